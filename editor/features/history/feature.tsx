import type { Feature } from '../feature.ts';
import { HistoryDialog } from './HistoryDialog.tsx';
import { historyCommands } from './history-commands.ts';
import { NameVersionDialog } from './NameVersionDialog.tsx';

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
