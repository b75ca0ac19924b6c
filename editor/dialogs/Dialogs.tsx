import { useEffect } from 'react';
import { useEditor } from '../context/index.ts';
import { ConflictDialog } from './ConflictDialog.tsx';
import { DropZone } from './DropZone.tsx';
import './dialogs.css';
import { fileCommands } from './file-commands.ts';
import { followDisagreement } from './follow-disagreement.ts';
import { HeldBackDialog } from './HeldBackDialog.tsx';
import { KeptDialog } from './KeptDialog.tsx';
import { LinkDialog } from './LinkDialog.tsx';
import { NewLevelDialog } from './NewLevelDialog.tsx';
import { ShareDialog } from './ShareDialog.tsx';
import { Tour } from './Tour.tsx';
import { TrashDialog } from './TrashDialog.tsx';
import { followLinks } from './take-link.ts';

/** What lies over the page now and then: new level, import and export, deleted levels, conflicts, the tour; files that are dropped, links that carry a level. */
export function Dialogs() {
  const editor = useEditor();
  useEffect(() => {
    const stops = [editor.commands.register(fileCommands(editor)), followDisagreement(editor), followLinks(editor)];
    return () => {
      for (const stop of stops) stop();
    };
  }, [editor]);
  return (
    <>
      <NewLevelDialog />
      <ShareDialog />
      <TrashDialog />
      <ConflictDialog />
      <KeptDialog />
      <Tour />
      <DropZone />
      <HeldBackDialog />
      <LinkDialog />
    </>
  );
}
