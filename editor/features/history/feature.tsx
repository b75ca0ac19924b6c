import type { Command } from '../../core/commands/index.ts';
import type { Editor } from '../../core/context/index.ts';
import { laterCover } from '../../core/panel/index.ts';
import type { Feature } from '../feature.ts';
import './history.css';

const HistoryDialog = laterCover(
  ({ overlay }) => overlay === 'history',
  () => import('./HistoryDialog.tsx').then((there) => there.HistoryDialog),
);
const NameVersionDialog = laterCover(
  ({ overlay }) => overlay === 'nameVersion',
  () => import('./NameVersionDialog.tsx').then((there) => there.NameVersionDialog),
);

function Dialogs() {
  return (
    <>
      <HistoryDialog />
      <NameVersionDialog />
    </>
  );
}

/** Earlier versions of the level, compared and restored. */
export const history: Feature = { name: 'history', dialogs: Dialogs, commands: historyCommands };

/** The keys of the history. */
const HISTORY_KEY = 'y';
const NAME_KEY = 'Shift+y';

/** Commands for the history of the open level. */
function historyCommands({ session, open }: Editor): readonly Command[] {
  const needs = () => (open.getState() === null ? 'open a level first' : null);
  return [
    {
      id: 'history.show',
      title: 'History of this level',
      group: 'File',
      keys: [HISTORY_KEY],
      needs,
      run: () => session.setState({ overlay: 'history' }),
    },
    {
      id: 'history.name',
      title: 'Name this version',
      group: 'File',
      keys: [NAME_KEY],
      needs,
      run: () => session.setState({ overlay: 'nameVersion' }),
    },
  ];
}
