export { checkContent, checkFiles, cutAtBail, levelChecker } from './check-files.ts';
export { type CheckedLevel, type CheckSettings, crashedLevel, keyOf, unreadableLevel } from './checked-level.ts';
export { CHECK_CODES } from './codes.ts';
export { openLevelCache } from './level-cache.ts';
export {
  type AskedOptions,
  FEW_FILES,
  judgeLevels,
  judgeOf,
  refuseLimitsWithoutSearch,
  SOFTLOCK_EFFORT,
  settingsFor,
} from './settings.ts';
export { exitCodeFor, exitCodeOf, isGood, type Totals, tooManyWarnings, totalsOf } from './totals.ts';
