export { type Cost, type EffectTime, measureCosts, type Player, playerOf, quantile, timeByEffect } from './cost.ts';
export * from './measure.ts';
