import { FileDown } from 'lucide-react';
import { useEffect, useState } from 'react';
import { useStore } from 'zustand';
import { placeIn } from '../../../schema/index.ts';
import { type Editor, useEditor } from '../../core/context/index.ts';
import { levelOf } from '../../core/exchange/index.ts';
import { folderOf } from '../../core/files/index.ts';
import { fetched, laterCover, laterPanel } from '../../core/panel/index.ts';
import { droppedFiles, openPlayFiles } from '../../core/plays/index.ts';
import { isPlayFile } from '../../core/shelf/index.ts';
import { Dialog } from '../../core/ui/index.ts';
import type { Feature } from '../feature.ts';
import './share.css';

const LinkedLevel = laterPanel(() => import('./LinkedLevel.tsx').then((there) => there.LinkedLevel));

/** Asks before a level from the page's address is added: any website can link here with one. */
export function LinkDialog() {
  const { incoming } = useEditor();
  const file = useStore(incoming);
  const close = () => incoming.setState(null, true);
  return (
    <Dialog
      open={file !== null}
      title="Add the level from the link?"
      about="The level comes from the author of the link. Nothing is stored unless you add it."
      onClose={close}
    >
      {file !== null && <LinkedLevel file={file} onClose={close} />}
    </Dialog>
  );
}

/** Takes the level out of the page's address and asks the user whether to add it; a reload does not ask again. */
async function takeLink({ notices, incoming }: Editor): Promise<void> {
  const { hash } = window.location;
  if (placeIn(hash) !== null) return;
  const linked = await levelOf(hash);
  if (linked === null) return;
  // a play beside the level is taken by itself
  if (hash.startsWith(window.location.hash) && window.location.hash !== '') {
    // A full URL: a path that begins with two slashes would otherwise name another host.
    const bare = new URL(window.location.href);
    bare.hash = '';
    window.history.replaceState(window.history.state, '', bare.href.replace(/#$/, ''));
  }
  if (linked.ok) incoming.setState(linked.file, true);
  else notices.show('error', linked.message, { topic: 'link' });
}

/**
 * Handles links once the list of levels is known: the link that opened the page, and links typed into its address. @returns
 * stops it
 */
export function followLinks(editor: Editor): () => void {
  const { store } = editor.workspace;
  const take = () => void takeLink(editor);
  let stop = () => {};
  const start = () => {
    stop();
    take();
    window.addEventListener('hashchange', take);
    stop = () => window.removeEventListener('hashchange', take);
  };
  if (store.getState().list !== null) start();
  else {
    stop = store.subscribe(({ list }) => {
      if (list !== null) start();
    });
  }
  return () => stop();
}

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
