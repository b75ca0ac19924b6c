import type { AnswerOf, AskedOf, Job, ProgressOf, Work } from './job.ts';
import * as jobs from './jobs/index.ts';

/** All records of jobs, by name. */
type Records = { [K in keyof typeof jobs as (typeof jobs)[K] extends Job ? K : never]: (typeof jobs)[K] };

export type JobKind = keyof Records;

/** What is asked of a worker, by kind. */
export type Requests = { [K in JobKind]: AskedOf<Records[K]> };
/** What it answers. */
export type Results = { [K in JobKind]: AnswerOf<Records[K]> };
/** What it reports on the way. */
type Progresses = { [K in JobKind]: ProgressOf<Records[K]> };

const all: readonly unknown[] = Object.values(jobs);
const isWork = (value: unknown): value is Work<Job> => typeof value === 'object' && value !== null && 'steps' in value;

/** How each job is done. Only a worker loads it. */
export const JOBS = Object.fromEntries(all.filter(isWork).map(({ of, steps }) => [of.name, steps])) as {
  readonly [K in JobKind]: (asked: Requests[K], now: () => number) => Generator<Progresses[K] | null, Results[K], void>;
};
