export { type Assumptions, type Fleet, inWords, type LevelCosts } from './assumptions.ts';
export { drawFleet, type Line } from './draw-fleet.ts';
export { drawSet, type Split, splitSet } from './draw-set.ts';
export { measureCosts } from './measure-costs.ts';
export { type Outcome, type Policy, type ShardCosts, simulateFleet } from './simulate-fleet.ts';
