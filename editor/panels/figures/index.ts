export type { Fact } from './fact.ts';
export { nextTurn, type TurnsOptions, timeInTurns } from './time-in-turns.ts';
export { about, extraInWords, percent, pixels, plural, seconds } from './words.ts';
