import { SPEED_LIMIT } from '../constants.ts';
import type { Effect } from './effect.ts';

export const blackHole: Effect = {
  name: 'black-hole',
  summary: 'touching it completes the level',
  calledFor: () => ({ called: true, because: 'every level has one' }),
};

export const range: Effect = {
  name: 'range',
  summary: 'farther than the range from every asteroid she is lost',
  calledFor: () => ({ called: true, because: 'every level has one' }),
};

export const speedLimit: Effect = {
  name: 'speed-limit',
  summary: `each component of a velocity stays within ${SPEED_LIMIT} px/s`,
  calledFor: () => ({ called: true, because: 'a long run may reach it' }),
};
