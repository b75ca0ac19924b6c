export { fileCommands } from './file-commands.ts';
export { HeldBackDialog } from './HeldBackDialog.tsx';
export { LevelsPanel } from './LevelsPanel.tsx';
export { NewLevelDialog } from './NewLevelDialog.tsx';
export { SamplesButton } from './SamplesButton.tsx';
export { TextDialog } from './TextDialog.tsx';
export { TrashDialog } from './TrashDialog.tsx';
