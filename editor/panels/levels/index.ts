export { LevelsPanel } from './LevelsPanel.tsx';
export {
  addLevels,
  deleteLevel,
  duplicateLevel,
  folderOf,
  nextNumber,
  openListed,
  restoreLevel,
  stemOf,
} from './level-files.ts';
export { fileNameProblem } from './RenameDialog.tsx';
export { TextDialog } from './TextDialog.tsx';
