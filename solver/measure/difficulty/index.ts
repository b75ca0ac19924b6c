export { GRADE_WORDS, type Grade, type GradeInput, type GradeWord, gradeOf, hardnessOf } from './grade.ts';
export { type ComparedRun, type FoundRuns, findRuns } from './level-runs.ts';
export { countOnePress, type OnePressCount, playAtRandom, playGameAtRandom, type RandomPlay } from './luck.ts';
export {
  type Difficulty,
  type DifficultyOptions,
  type MineralsExtra,
  measureDifficulty,
  PLAYER_EFFORT,
  type RunComparison,
} from './measure-difficulty.ts';
export {
  type AsteroidUse,
  findShortcuts,
  type OnePress,
  type ShortcutOptions,
  type Shortcuts,
  type WithoutAsteroid,
} from './shortcuts.ts';
export { type SigmaAtHalf, sigmaAtHalfOf } from './sigma-at-half.ts';
