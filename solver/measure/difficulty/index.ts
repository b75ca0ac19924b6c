export type { ComparedRun } from './compare-runs.ts';
export { type FoundRuns, findRuns } from './find-runs.ts';
export { GRADE_WORDS, type Grade, type GradeInput, type GradeWord, gradeOf, hardnessOf } from './grade.ts';
export {
  type Difficulty,
  type DifficultyOptions,
  type MineralsExtra,
  measureDifficulty,
  PLAYER_EFFORT,
  type RunComparison,
} from './measure-difficulty.ts';
export { countOnePress, type OnePressCount } from './one-press.ts';
export {
  createPlayers,
  type FitInterval,
  type ForecastAttempt,
  fitPlayers,
  type ObservedAttempt,
  type PlayedAttempt,
  type PlayerFit,
  type PlayerForecast,
  type PlayerOptions,
  type PlayerParameters,
  type PlayerPopulation,
  type PlayerShare,
  playAsPlayers,
  UNCALIBRATED,
} from './player/index.ts';
export { playAtRandom, playGameAtRandom, type RandomPlay } from './random-play.ts';
export { findShortcuts, type OnePress, type ShortcutOptions, type Shortcuts } from './shortcuts.ts';
export { type SigmaAtHalf, sigmaAtHalfOf } from './sigma-at-half.ts';
export type { AsteroidUse, WithoutAsteroid } from './without-asteroid.ts';
