export { cutAtBail } from './bail.ts';
export { checkContent, checkFiles } from './check-files.ts';
export type { CheckedLevel, CheckSettings } from './checked-level.ts';
export { CHECK_CODES } from './codes.ts';
export { judgeLevels, judgeOf } from './judge-levels.ts';
export { openLevelCache } from './level-cache.ts';
export { keyOf } from './problem-keys.ts';
export { unreadableLevel } from './refused-level.ts';
export { countWarnings, exitCodeOf, summarize, tooManyWarnings } from './summary.ts';
