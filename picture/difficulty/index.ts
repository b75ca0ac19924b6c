export type { Ground } from '../ink.ts';
export { type DifficultyPicture, drawDifficulty } from './draw-difficulty.ts';
