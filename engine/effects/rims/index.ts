export { countCrossing, roundingOnRim } from './chatter.ts';
export { offerCrossing } from './cross.ts';
