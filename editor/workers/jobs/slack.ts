import { compile } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { type EdgeSlack, findSlackInSteps, type Goal } from '../../../solver/index.ts';
import { job, type Played, type Work } from '../job.ts';

/** How far each press and release of a run may slip alone. */
export const slack = job<Played & { readonly holds: readonly Hold[]; readonly goal: Goal }, readonly EdgeSlack[]>({
  name: 'slack',
  lane: 'quick',
  most: 20_000,
});

export const slackWork: Work<typeof slack> = {
  of: slack,
  steps: ({ level, terms, holds, goal }) => findSlackInSteps(compile(level, terms), holds, goal),
};
