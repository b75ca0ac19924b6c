import { Files } from 'lucide-react';
import { flushSync } from 'react-dom';
import type { Feature } from '../feature.ts';
import { HeldBackDialog } from './HeldBackDialog.tsx';
import { LevelsPanel } from './LevelsPanel.tsx';
import './dialogs.css';
import type { Command, Destination } from '../../core/commands/index.ts';
import type { Editor } from '../../core/context/index.ts';
import { folderOf } from '../../core/files/index.ts';
import { addSamples, deleteLevel, duplicateLevel, openListed } from '../../core/levels/index.ts';
import { laterCover } from '../../core/panel/index.ts';

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
