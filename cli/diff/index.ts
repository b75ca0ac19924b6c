export { chooseComparison, compareFiles } from './choose-comparison.ts';
export { type DiffedLevel, type DiffSettings, type DiffStatus, type JudgedVersion, termsOfSides } from './comparison.ts';
export { type Diff, diffFiles } from './diff-files.ts';
export { type PlayedVersion, type PlayedVersions, playVersions } from './versions.ts';
