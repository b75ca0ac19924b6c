import { Files } from 'lucide-react';
import { flushSync } from 'react-dom';
import { useStore } from 'zustand';
import type { Command, Destination } from '../../core/commands/index.ts';
import { type Editor, useEditor } from '../../core/context/index.ts';
import { folderOf } from '../../core/files/index.ts';
import { addSamples, deleteLevel, duplicateLevel, openHeldBack, openListed } from '../../core/levels/index.ts';
import { laterCover } from '../../core/panel/index.ts';
import { Button, Dialog } from '../../core/ui/index.ts';
import type { Feature } from '../feature.ts';
import { LevelsPanel } from './LevelsPanel.tsx';
import './dialogs.css';

/**
 * Asks what to do with a level that was being opened when the page last stopped. Opening it again automatically could make the
 * editor unusable.
 */
export function HeldBackDialog() {
  const editor = useEditor();
  const { heldBack, workspace, marks } = editor;
  const id = useStore(heldBack);
  const list = useStore(workspace.store, (state) => state.list);
  const entry = list?.levels.find((level) => level.id === id);
  const other = list?.levels.find(({ id, status }) => status === 'valid' && !marks.has(`${list.folder.id}/${id}`));
  const close = () => heldBack.setState(null, true);
  const act = (what: () => Promise<void>) => () => {
    close();
    void what();
  };
  return (
    <Dialog
      open={id !== null && entry !== undefined}
      title="This level was not opened"
      about="The page was opening this level when it last stopped. Either the page was closed at that moment, or the level was too much work for it."
      onClose={close}
    >
      {id !== null && entry !== undefined && (
        <div className="form link">
          <p className="link__name">{entry.name ?? id}</p>
          <p className="link__text">{entry.file}</p>
          <div className="form__buttons">
            <Button hint="Move it to the deleted levels" look="outlined" onClick={act(() => deleteLevel(editor, entry))}>
              Delete
            </Button>
            {other !== undefined && (
              <Button hint={`Open ${other.name ?? other.id}`} look="outlined" onClick={act(() => openListed(editor, other.id))}>
                Open another level
              </Button>
            )}
            <Button hint="Open it like any other level" look="outlined" onClick={act(() => openHeldBack(editor, id, true))}>
              Open anyway
            </Button>
            <Button
              hint="Open it for editing only: it is not simulated and not searched"
              look="main"
              onClick={act(() => openHeldBack(editor, id, false))}
            >
              Open without checks
            </Button>
          </div>
        </div>
      )}
    </Dialog>
  );
}

const NewLevelDialog = laterCover(
  ({ overlay }) => overlay === 'newLevel',
  () => import('./NewLevelDialog.tsx').then((there) => there.NewLevelDialog),
);
const TrashDialog = laterCover(
  ({ overlay }) => overlay === 'trash',
  () => import('./TrashDialog.tsx').then((there) => there.TrashDialog),
);

function Dialogs() {
  return (
    <>
      <NewLevelDialog />
      <TrashDialog />
      <HeldBackDialog />
    </>
  );
}

/** The list of levels, and what is done with their files. */
export const levels: Feature = {
  name: 'levels',
  panel: {
    id: 'levels',
    title: 'Levels',
    icon: <Files size={17} />,
    side: 'left',
    place: 'fixed',
    content: LevelsPanel,
  },
  dialogs: Dialogs,
  destinations: levelDestinations,
  commands: (editor) => {
    const { session, commands } = editor;
    return [
      ...fileCommands(editor),
      {
        id: 'file.new',
        title: 'New level',
        group: 'File',
        keys: ['Alt+n'],
        inText: true,
        run: () => session.setState({ overlay: 'newLevel' }),
      },
      { id: 'file.trash', title: 'Deleted levels', group: 'File', run: () => session.setState({ overlay: 'trash' }) },
      {
        id: 'file.find',
        title: 'Find a level',
        group: 'File',
        keys: ['$mod+p'],
        inText: true,
        run: () => {
          // Where panels are shown one at a time, the list may not be rendered yet.
          flushSync(() => commands.run('panel.levels'));
          const field = document.querySelector<HTMLInputElement>('.levels input[type="search"]');
          field?.focus();
          field?.select();
        },
      },
    ];
  },
};

/** Commands for the open level as a file. */
function fileCommands(editor: Editor): readonly Command[] {
  const { workspace, session } = editor;
  const entry = () => {
    const { list, opened } = workspace.store.getState();
    return list?.levels.find(({ id }) => id === opened?.id());
  };
  const needsListed = () => (entry() === undefined ? 'open a level first' : null);
  const step = (by: number) => {
    const { list, opened } = workspace.store.getState();
    const valid = list?.levels.filter(({ status }) => status === 'valid') ?? [];
    const index = valid.findIndex(({ id }) => id === opened?.id());
    const next = valid[index + by];
    if (next !== undefined) void openListed(editor, next.id);
  };
  const withEntry = (act: (found: NonNullable<ReturnType<typeof entry>>) => Promise<void>) => () => {
    const found = entry();
    if (found !== undefined) void act(found);
  };
  return [
    {
      id: 'file.next',
      title: 'Next level',
      group: 'File',
      keys: ['Alt+PageDown'],
      inText: true,
      needs: needsListed,
      run: () => step(1),
    },
    {
      id: 'file.previous',
      title: 'Previous level',
      group: 'File',
      keys: ['Alt+PageUp'],
      inText: true,
      needs: needsListed,
      run: () => step(-1),
    },
    {
      id: 'file.duplicate',
      title: 'Duplicate this level',
      group: 'File',
      needs: needsListed,
      run: withEntry((e) => duplicateLevel(editor, e)),
    },
    {
      id: 'file.delete',
      title: 'Delete this level',
      group: 'File',
      needs: needsListed,
      run: withEntry((e) => deleteLevel(editor, e)),
    },
    {
      id: 'file.samples',
      title: 'Add sample levels',
      group: 'File',
      run: () => void addSamples(editor, folderOf(workspace.store.getState().opened?.id() ?? '')),
    },
    { id: 'file.import', title: 'Import levels', group: 'File', run: () => session.setState({ overlay: 'open' }) },
  ];
}

/** The other levels that can be opened. */
function levelDestinations(editor: Editor): readonly Destination[] {
  const { list, opened } = editor.workspace.store.getState();
  return (list?.levels ?? [])
    .filter(({ id, status }) => status === 'valid' && id !== opened?.id())
    .map(({ id, name }) => ({
      key: `level ${id}`,
      group: 'Level',
      title: name ?? id,
      detail: id,
      go: () => void openListed(editor, id),
    }));
}
