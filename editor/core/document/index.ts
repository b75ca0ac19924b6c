export { createEditedLevel } from './document.ts';
export type { ChangeResult, DocumentEvent, DocumentState, EditedLevel, Gesture, Recipe, StepMark } from './edited-level.ts';
export { enteredGroup, freeGroupName, groupOf, unitOf, withGroups } from './groups.ts';
export { levelText } from './level-text.ts';
export { createListeners } from './listeners.ts';
export {
  grabbableIn,
  groupsIn,
  hiddenIn,
  LONGEST_NAME,
  lockedIn,
  MARK_KEYS,
  type Mark,
  type Marks,
  marksOf,
  unlocked,
  visibleIn,
} from './marks.ts';
export { nameOf, ownNameOf, titled } from './names.ts';
export {
  ASTRONAUT,
  BLACK_HOLE,
  type FoundObject,
  keyAt,
  type ObjectKey,
  objectsOf,
} from './objects.ts';
export * from './operations/index.ts';
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
export { placesOf } from './places.ts';
export { createSelection, type SelectionStore } from './selection.ts';
export { settle } from './settle.ts';
