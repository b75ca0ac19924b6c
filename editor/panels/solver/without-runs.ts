import type { Level } from '../../../schema/index.ts';

/** The level without its runs: what a worker needs. */
export const withoutRuns = (level: Level): Level => ({ ...level, runs: [] });
