import type { Contents } from '../io/index.ts';

/** What can be done with a large set; each is the command of that name. */
export const JOBS = ['check', 'solve', 'difficulty', 'verify'] as const;

export type JobName = (typeof JOBS)[number];

/** What a set consists of that a job works on. */
export const contentsOf = (job: string): Contents => (job === 'verify' ? 'plays' : 'levels');
