export { countCrossing, roundingOnRim } from './chatter.ts';
export { offerCrossing } from './cross.ts';
export { ENTERING, OUTSIDE, placeInCircle } from './inside.ts';
