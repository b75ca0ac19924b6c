export {
  copyObjects,
  duplicateObjects,
  MOST_COPIES,
  middleOf,
  pasteObjects,
  type Repetition,
  readClipping,
  repeatObjects,
} from './copy-objects.ts';
export { createEditedLevel } from './document.ts';
export { addHold, deleteHolds, holdsOf, moveHold, splitHold, stretchHold } from './edit-holds.ts';
export { type LevelProperty, resetRules, setLevelProperty, setRule } from './edit-level.ts';
export {
  addObject,
  deleteObjects,
  moveObjects,
  reorderObject,
  scaleRadius,
  setObjectProperty,
  setRadius,
} from './edit-objects.ts';
export {
  addNote,
  addRun,
  deleteNote,
  deleteRun,
  duplicateRun,
  freeRunName,
  moveNote,
  notesOf,
  renameRun,
  reorderRun,
  replaceHolds,
  rewordNote,
  writeScript,
} from './edit-runs.ts';
export {
  type ChangeResult,
  createListeners,
  type DocumentEvent,
  type DocumentState,
  type EditedLevel,
  type Gesture,
  levelText,
  type Recipe,
  type StepMark,
} from './edited-level.ts';
export {
  canBeMarked,
  enteredGroup,
  freeGroupName,
  grabbableIn,
  groupOf,
  groupsIn,
  hiddenIn,
  LONGEST_NAME,
  lockedIn,
  MARK_KEYS,
  type Mark,
  type Marks,
  marksOf,
  nameOf,
  ownNameOf,
  renameGroup,
  setMark,
  titled,
  unitOf,
  unlocked,
  visibleIn,
  withGroups,
} from './marks.ts';
export { normalize } from './normalize.ts';
export { ASTRONAUT, BLACK_HOLE, type FoundObject, keyAt, type ObjectKey, objectsOf, placesOf, radiusOf } from './objects.ts';
export { applyPatches, diffFiles, type Patch } from './patch.ts';
export {
  editPinnedNote,
  LONGEST_PINNED_NOTE,
  type PinnedNote,
  pinNote,
  pinnedNotesIn,
  pinProblem,
  unpinNote,
} from './pinned-notes.ts';
export { createSelection, type SelectionStore } from './selection.ts';
export {
  alignObjects,
  distributeObjects,
  type Edge,
  hasDirection,
  type LinearMap,
  mapObjects,
  mapProblem,
  mirrorAlong,
  type Scaling,
  scaleObjects,
  turnBy,
} from './transform-objects.ts';
