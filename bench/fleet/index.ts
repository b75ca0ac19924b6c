export { type Assumptions, type Fleet, inWords, type LevelCosts, type Measured } from './assumptions.ts';
export { drawFleet, type Line } from './draw-fleet.ts';
export { type DrawnSet, drawSet, type Split, splitSet } from './draw-set.ts';
export { measureCosts } from './measure-costs.ts';
export { type Outcome, type Policy, type ShardCosts, simulateFleet } from './simulate-fleet.ts';
