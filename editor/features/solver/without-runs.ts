import type { Level } from '../../../schema/index.ts';

/** The level without its runs, as workers get it. */
export const withoutRuns = (level: Level): Level => ({ ...level, runs: [] });
