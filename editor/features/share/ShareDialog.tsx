import { Tabs } from 'radix-ui';
import { useStore } from 'zustand';
import { LevelContext, useEditor, useSession } from '../../core/context/index.ts';
import { Dialog } from '../../core/ui/index.ts';
import { ExportTab } from './ExportTab.tsx';
import { ImportTab } from './ImportTab.tsx';
import { LinkTab } from './LinkTab.tsx';
import { PublishTab } from './PublishTab.tsx';

/** Imports and exports levels. */
export function ShareDialog() {
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
