import { useEffect } from 'react';
import { useEditor } from '../core/context/index.ts';
import { ConflictDialog, followDisagreement } from '../features/conflicts/index.ts';
import { HistoryDialog, historyCommands, NameVersionDialog } from '../features/history/index.ts';
import { DropZone, followLinks, LinkDialog, ShareDialog } from '../features/share/index.ts';
import './dialogs.css';
import { KeptDialog } from '../features/kept/index.ts';
import { fileCommands, HeldBackDialog, NewLevelDialog, TrashDialog } from '../features/levels/index.ts';
import { Tour } from '../features/tour/index.ts';

/** All dialogs of the page, the drop zone for files, and the handling of links that contain a level. */
export function Dialogs() {
  const editor = useEditor();
  useEffect(() => {
    const stops = [
      editor.commands.register([...fileCommands(editor), ...historyCommands(editor)]),
      followDisagreement(editor),
      followLinks(editor),
    ];
    return () => {
      for (const stop of stops) stop();
    };
  }, [editor]);
  return (
    <>
      <NewLevelDialog />
      <ShareDialog />
      <TrashDialog />
      <HistoryDialog />
      <NameVersionDialog />
      <ConflictDialog />
      <KeptDialog />
      <Tour />
      <DropZone />
      <HeldBackDialog />
      <LinkDialog />
    </>
  );
}
