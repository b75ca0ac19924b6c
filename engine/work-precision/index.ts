export {
  type Cost,
  EFFECT_TIMING,
  type EffectTime,
  FEWEST_ROUNDS,
  measureCosts,
  type Player,
  playerOf,
  quantile,
  timeByEffect,
} from './cost.ts';
export * from './measure.ts';
