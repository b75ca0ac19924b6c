export { amountsOf, type Change, parseChange, parseSweep, type Sweep } from './rule-options.ts';
export { type RuleInterval, type TunedLevel, type TunedState, type TuneSettings, tuneLevels } from './tuned-level.ts';
