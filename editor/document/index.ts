export {
  type ChangeResult,
  createEditedLevel,
  type DocumentEvent,
  type DocumentState,
  type EditedLevel,
  type Gesture,
  type Recipe,
} from './document.ts';
export { enteredGroup, freeGroupName, groupOf, unitOf, withGroups } from './groups.ts';
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
export { addNote, deleteNote, editNote, LONGEST_NOTE, type Note, noteProblem, notesIn } from './notes.ts';
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
export { placesOf } from './places.ts';
export { createSelection, type SelectionStore } from './selection.ts';
export { settle } from './settle.ts';
