export { compareWith, type Deviation, deviationOf } from './compare.ts';
export { type Cost, measureCosts, type Player, playerOf, quantile } from './cost.ts';
export { cheapestGoodEnough, GOOD_ENOUGH, type Measured, measureWorkPrecision, type WorkPrecision } from './measure.ts';
export { METHODS, RATES, TOLERANCES } from './methods.ts';
export { largestDistance, type Path, pathOf } from './path.ts';
export { REFERENCE_TOLERANCE, type Reference, referenceOf } from './reference.ts';
export { missedContacts } from './tunnelling.ts';
