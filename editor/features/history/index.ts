export { HistoryDialog } from './HistoryDialog.tsx';
export { HISTORY_KEY, historyCommands } from './history-commands.ts';
export { NameVersionDialog } from './NameVersionDialog.tsx';
