import { useEffect } from 'react';
import { useEditor, useLevel } from '../context/index.ts';
import { compareCommands } from './compare-commands.ts';
import { watchCompared } from './watch-compared.ts';

/** Renders nothing. Registers the commands of compared runs and keeps their trajectories up to date, whichever panel is open. */
export function ComparedWatch() {
  const editor = useEditor();
  const level = useLevel();
  useEffect(() => watchCompared(level, editor.desk), [editor, level]);
  useEffect(() => editor.commands.register(compareCommands(editor, level)), [editor, level]);
  return null;
}
