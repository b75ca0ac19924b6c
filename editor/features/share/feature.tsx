import type { Feature } from '../feature.ts';
import { followLinks, LinkDialog } from './LinkDialog.tsx';
import './share.css';
import { FileDown } from 'lucide-react';
import { Tabs } from 'radix-ui';
import { useEffect, useState } from 'react';
import { useStore } from 'zustand';
import { LevelContext, useEditor, useSession } from '../../core/context/index.ts';
import { folderOf } from '../../core/files/index.ts';
import { droppedFiles, openPlayFiles } from '../../core/plays/index.ts';
import { isPlayFile } from '../../core/shelf/index.ts';
import { Dialog } from '../../core/ui/index.ts';
import { ExportTab } from './ExportTab.tsx';
import { ImportTab } from './ImportTab.tsx';
import { IMPORT_TOPIC, importFiles } from './import-files.ts';
import { LinkTab } from './LinkTab.tsx';
import { PublishTab } from './PublishTab.tsx';

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

/** Imports and exports levels. */
function ShareDialog() {
  const editor = useEditor();
  const { session } = editor;
  const overlay = useSession((state) => state.overlay);
  const level = useStore(editor.open);
  const close = () => session.setState({ overlay: null });
  const first = overlay === 'publish' ? 'publish' : overlay === 'open' || level === null ? 'import' : 'export';
  return (
    <Dialog
      open={overlay === 'share' || overlay === 'open' || overlay === 'publish'}
      wide
      title={overlay === 'publish' ? 'Publish' : 'Import, export, link'}
      about="Levels stay on this machine: a link contains the level itself and is not sent to a server."
      onClose={close}
    >
      <LevelContext.Provider value={level}>
        <Tabs.Root key={first} defaultValue={first}>
          <Tabs.List className="tabs share__tabs" aria-label="Ways to share">
            <Tabs.Trigger value="export" className="tabs__tab" disabled={level === null}>
              Export
            </Tabs.Trigger>
            <Tabs.Trigger value="link" className="tabs__tab" disabled={level === null}>
              Link
            </Tabs.Trigger>
            <Tabs.Trigger value="publish" className="tabs__tab">
              Publish
            </Tabs.Trigger>
            <Tabs.Trigger value="import" className="tabs__tab">
              Import
            </Tabs.Trigger>
          </Tabs.List>
          <Tabs.Content value="export">{level !== null && <ExportTab />}</Tabs.Content>
          <Tabs.Content value="link">{level !== null && <LinkTab />}</Tabs.Content>
          <Tabs.Content value="publish">
            <PublishTab />
          </Tabs.Content>
          <Tabs.Content value="import">
            <ImportTab onClose={close} />
          </Tabs.Content>
        </Tabs.Root>
      </LevelContext.Provider>
    </Dialog>
  );
}

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
      notices.clear(IMPORT_TOPIC);
      const take = async (files: readonly File[]) => {
        const plays = files.filter(isPlayFile);
        const levels = files.filter((file) => !isPlayFile(file));
        if (plays.length > 0) void openPlayFiles(editor, plays);
        if (levels.length === 0) return;
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
