export { amountsOf, type Change, parseChange, parseSweep, type Sweep } from './rule-options.ts';
export { tuneLevels, type RuleInterval, type TunedLevel, type TunedState, type TuneSettings } from './tuned-level.ts';
