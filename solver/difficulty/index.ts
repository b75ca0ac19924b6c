export { GRADE_WORDS, type Grade, type GradeWord } from './grade.ts';
export { type Difficulty, type DifficultyOptions, type MineralsExtra, measureDifficulty } from './measure-difficulty.ts';
export type { RandomPlay } from './random-play.ts';
export { findShortcuts, type OnePress, type ShortcutOptions, type Shortcuts } from './shortcuts.ts';
export type { SigmaAtHalf } from './sigma-at-half.ts';
export type { AsteroidUse, WithoutAsteroid } from './without-asteroid.ts';
