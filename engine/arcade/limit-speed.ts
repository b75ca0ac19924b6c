import { SPEED_LIMIT } from '../constants.ts';

// V8 folds a constant of the same module; an imported one is a box to it, and so would be what is chosen between it and a number
const LIMIT = SPEED_LIMIT;

/** Holds one axis of a velocity to the speed limit, px/s. */
export const limitSpeed = (v: number): number => (v > LIMIT ? LIMIT : v < -LIMIT ? -LIMIT : v);
