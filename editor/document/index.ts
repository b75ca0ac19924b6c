export {
  type ChangeResult,
  createEditedLevel,
  type DocumentEvent,
  type DocumentState,
  type EditedLevel,
  type Gesture,
  type Recipe,
} from './document.ts';
export { KIND_NAMES, nameOf } from './names.ts';
export {
  ASTRONAUT,
  BLACK_HOLE,
  type FoundObject,
  KIND_OF_LIST,
  keyAt,
  LIST_OF_KIND,
  type ObjectKey,
  type ObjectKind,
  objectsOf,
} from './objects.ts';
export * from './operations/index.ts';
export { inPageWords } from './page-words.ts';
export { applyPatches, diffFiles, isSame, type Patch } from './patch.ts';
export { createSelection, type SelectionStore } from './selection.ts';
export { settle } from './settle.ts';
