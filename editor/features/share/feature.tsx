import type { Feature } from '../feature.ts';
import { followLinks, LinkDialog } from './LinkDialog.tsx';
import './share.css';
import { FileDown } from 'lucide-react';
import { useEffect, useState } from 'react';
import { useEditor } from '../../core/context/index.ts';
import { folderOf } from '../../core/files/index.ts';
import { fetched, laterCover } from '../../core/panel/index.ts';
import { droppedFiles, openPlayFiles } from '../../core/plays/index.ts';
import { isPlayFile } from '../../core/shelf/index.ts';

const ShareDialog = laterCover(
  ({ overlay }) => overlay === 'share' || overlay === 'open' || overlay === 'publish',
  () => import('./ShareDialog.tsx').then((there) => there.ShareDialog),
);

function Dialogs() {
  return (
    <>
      <ShareDialog />
      <DropZone />
      <LinkDialog />
    </>
  );
}

/** Levels as files, links and pages, and those that are dropped or linked. */
export const share: Feature = {
  name: 'share',
  dialogs: Dialogs,
  start: followLinks,
  commands: ({ session }) => [
    {
      id: 'file.share',
      title: 'Import, export, link',
      group: 'File',
      run: () => session.setState({ overlay: 'share' }),
    },
    {
      id: 'file.publish',
      title: 'Publish as a page to play',
      group: 'File',
      run: () => session.setState({ overlay: 'publish' }),
    },
  ],
};

const hasFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes('Files') === true;

/** Imports levels and opens plays that are dropped anywhere on the page, as files or in folders. */
function DropZone() {
  const editor = useEditor();
  const [isOver, setIsOver] = useState(false);
  useEffect(() => {
    const stopping = new AbortController();
    // Entering a child fires before leaving its parent, so the drag has left the page when the depth is 0.
    let depth = 0;
    const listen = (type: 'dragenter' | 'dragover' | 'dragleave' | 'drop', act: (event: DragEvent) => void) =>
      window.addEventListener(type, (event) => hasFiles(event) && act(event), { signal: stopping.signal, capture: true });
    listen('dragenter', (event) => {
      event.preventDefault();
      depth++;
      setIsOver(true);
    });
    listen('dragover', (event) => {
      event.preventDefault();
      if (event.dataTransfer !== null) event.dataTransfer.dropEffect = 'copy';
    });
    listen('dragleave', () => {
      depth = Math.max(0, depth - 1);
      if (depth === 0) setIsOver(false);
    });
    listen('drop', (event) => {
      event.preventDefault();
      event.stopPropagation();
      depth = 0;
      setIsOver(false);
      const folder = folderOf(editor.workspace.store.getState().opened?.id() ?? '');
      const { notices } = editor;
      const take = async (files: readonly File[]) => {
        const plays = files.filter(isPlayFile);
        const levels = files.filter((file) => !isPlayFile(file));
        if (plays.length > 0) void openPlayFiles(editor, plays);
        if (levels.length === 0) return;
        const there = await fetched(editor, () => import('./ImportTab.tsx'));
        if (there === null) return;
        const { IMPORT_TOPIC, importFiles } = there;
        notices.clear(IMPORT_TOPIC);
        const { refusals } = await importFiles(editor, folder, levels, true);
        if (refusals.length > 0) notices.show('error', refusals.join('\n'), { topic: IMPORT_TOPIC });
      };
      if (event.dataTransfer !== null) void droppedFiles(event.dataTransfer).then(take);
    });
    return () => stopping.abort();
  }, [editor]);
  if (!isOver) return null;
  return (
    <div className="dropzone" role="status">
      <FileDown size={28} aria-hidden />
      Drop levels to import them, plays to open them
    </div>
  );
}
