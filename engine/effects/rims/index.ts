export { countCrossing, rimTolerance, roundingOnRim } from './chatter.ts';
