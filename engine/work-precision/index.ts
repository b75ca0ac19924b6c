export { type Cost, measureCosts, type Player, playerOf, quantile } from './cost.ts';
export * from './measure.ts';
