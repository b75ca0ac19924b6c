export { openIndexedDbVersions } from './indexed-db-versions.ts';
export type { LevelVersions } from './level-versions.ts';
export { createMemoryVersions } from './memory-versions.ts';
export { historyAt, moveHeads } from './stored-heads.ts';
export { type PastVersion, VERSION_MAKERS, type Version, type VersionBy } from './version.ts';
export { createVersionKeeper, type VersionKeeper } from './version-keeper.ts';
export { type Head, type Move, movedHeads, type VersionStore } from './version-store.ts';
