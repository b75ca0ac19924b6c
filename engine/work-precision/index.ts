export { type Cost, measureCosts, type Player, playerOf, quantile, timeByEffect } from './cost.ts';
export * from './measure.ts';
