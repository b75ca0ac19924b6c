export { addObject } from './add-object.ts';
export { alignObjects, distributeObjects, type Edge } from './align-objects.ts';
export { copyObjects, duplicateObjects } from './copy-objects.ts';
export { deleteObjects } from './delete-objects.ts';
export { addHold, deleteHolds, holdsOf, moveHold, splitHold, stretchHold } from './edit-holds.ts';
export { type LevelProperty, setLevelProperty, setObjectProperty } from './edit-level.ts';
export { canBeMarked, renameGroup, setMark } from './edit-marks.ts';
export { addNote, deleteNote, moveNote, notesOf, rewordNote, writeScript } from './edit-notes.ts';
export { resetRules, setRule } from './edit-rules.ts';
export { addRun, deleteRun, duplicateRun, freeRunName, renameRun, reorderRun, replaceHolds } from './edit-runs.ts';
export { moveObjects } from './move-objects.ts';
export { middleOf, pasteObjects, readClipping } from './paste-objects.ts';
export { reorderObject } from './reorder-object.ts';
export { MOST_COPIES, type Repetition, repeatObjects } from './repeat-objects.ts';
export { radiusOf, scaleRadius, setRadius } from './resize-objects.ts';
export {
  hasDirection,
  type LinearMap,
  mapObjects,
  mapProblem,
  mirrorAlong,
  type Scaling,
  scaleObjects,
  turnBy,
} from './transform-objects.ts';
