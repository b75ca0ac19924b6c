export { chooseComparison } from './choose-comparison.ts';
export { compareFiles } from './compare-paths.ts';
export { termsOfSides } from './comparison.ts';
export { type Diff, diffFiles } from './diff-files.ts';
export type { DiffedLevel, DiffSettings, DiffStatus, JudgedVersion } from './diffed-level.ts';
export { type PlayedVersion, type PlayedVersions, playVersions } from './versions.ts';
