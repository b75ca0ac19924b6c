export type { Ground } from '../ink.ts';
export { drawTuning } from './draw-tuning.ts';
