export { FileNameFields, fileNameProblem } from './FileNameFields.tsx';
export { FolderSelect } from './FolderSelect.tsx';
export { LevelsPanel } from './LevelsPanel.tsx';
export {
  addLevels,
  addSamples,
  copyOf,
  deleteLevel,
  duplicateLevel,
  nextNumber,
  openFirst,
  openHeldBack,
  openListed,
  restoreLevel,
  stemOf,
} from './level-files.ts';
export { listHistoryOf } from './list-history.ts';
export { editPack } from './pack-steps.ts';
export { SamplesButton } from './SamplesButton.tsx';
export { TextDialog } from './TextDialog.tsx';
export { factsKey, factsOf, pictureOf, thumbnailKey, thumbnailsOf, verdictOf } from './thumbnails.ts';
export { type ListedVerdict, VerdictSign } from './VerdictSign.tsx';
