export { keepAsRun, keepHolds, makeProof } from './keep-attempt.ts';
export {
  addLevels,
  addSamples,
  copyOf,
  deleteLevel,
  duplicateLevel,
  followSaves,
  inFolder,
  nextNumber,
  openFirst,
  openHeldBack,
  openListed,
  orderLevels,
  renameTitle,
  restoreLevel,
  stemOf,
} from './level-files.ts';
export { listHistoryOf } from './list-history.ts';
export { changePack, editPack } from './pack-steps.ts';
export {
  factsKey,
  factsOf,
  type ListedVerdict,
  pictureOf,
  thumbnailKey,
  thumbnailsOf,
  VerdictSign,
  verdictOf,
} from './thumbnails.tsx';
