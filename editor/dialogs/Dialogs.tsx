import { useEffect } from 'react';
import { useEditor } from '../core/context/index.ts';
import { HistoryDialog, historyCommands, NameVersionDialog } from '../panels/history/index.ts';
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
