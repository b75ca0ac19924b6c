export type { LevelVersions } from './level-versions.ts';
export { type PastVersion, VERSION_MAKERS, type Version, type VersionBy } from './version.ts';
export { createVersionKeeper, type VersionKeeper } from './version-keeper.ts';
export * from './version-store.ts';
