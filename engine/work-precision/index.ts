export { type Cost, measureCosts, type Player, playerOf, quantile } from './cost.ts';
export {
  cheapestGoodEnough,
  compareWith,
  type Deviation,
  deviationOf,
  GOOD_ENOUGH,
  largestDistance,
  METHODS,
  type Measured,
  measureWorkPrecision,
  type Path,
  pathOf,
  RATES,
  REFERENCE_TOLERANCE,
  type Reference,
  referenceOf,
  TOLERANCES,
  type WorkPrecision,
} from './measure.ts';
export { missedContacts } from './tunnelling.ts';
