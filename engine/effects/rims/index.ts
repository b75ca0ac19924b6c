export { countCrossing, rimTolerance, roundingOnRim } from './chatter.ts';
export { offerCrossing } from './cross.ts';
