export type { LevelVersions } from './level-versions.ts';
export { type PastVersion, VERSION_MAKERS, type Version, type VersionBy } from './version.ts';
export { createVersionKeeper, type VersionKeeper } from './version-keeper.ts';
export {
  createMemoryVersions,
  type Head,
  historyAt,
  type Move,
  movedHeads,
  moveHeads,
  openIndexedDbVersions,
  type VersionStore,
} from './version-store.ts';
