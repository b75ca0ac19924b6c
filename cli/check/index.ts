export { cutAtBail, checkContent, checkFiles, levelChecker } from './check-files.ts';
export { type CheckedLevel, type CheckSettings, keyOf, crashedLevel, unreadableLevel } from './checked-level.ts';
export { CHECK_CODES } from './codes.ts';
export { judgeLevels, judgeOf, type AskedOptions, FEW_FILES, refuseLimitsWithoutSearch, SOFTLOCK_EFFORT, settingsFor } from './settings.ts';
export { openLevelCache } from './level-cache.ts';
export { exitCodeFor, exitCodeOf, tooManyWarnings, isGood, type Totals, totalsOf } from './totals.ts';
