export { amountsOf, type Change, parseChange, parseSweep, type Sweep } from './rule-options.ts';
export { tuneLevels } from './tune-levels.ts';
export type { RuleInterval, TunedLevel, TunedState, TuneSettings } from './tuned-level.ts';
