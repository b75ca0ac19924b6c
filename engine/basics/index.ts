// What options and reports need of the engine. The engine itself takes longer to load than node takes to start, and a check whose
// reports are all in the cache needs no engine.
export { ACCURACIES, ACCURACY_LIMITS, type Accuracy, type AccuracyName, accuracyOf } from '../accuracy.ts';
export { MORE_WARNINGS, TICK, TICK_RATE } from '../constants.ts';
export { joinHolds } from '../script.ts';
export { DEFAULT_TERMS, maxTicksOf, type Terms, unusualTerms } from '../terms.ts';
