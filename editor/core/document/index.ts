export * from './copy-objects.ts';
export { createEditedLevel } from './document.ts';
export { addHold, deleteHolds, holdsOf, moveHold, splitHold, stretchHold } from './edit-holds.ts';
export * from './edit-objects.ts';
export * from './edit-runs.ts';
export * from './edited-level.ts';
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
export * from './pinned-notes.ts';
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
