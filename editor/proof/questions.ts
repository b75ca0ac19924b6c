import type { Terms } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import type { Goal } from '../../solver/index.ts';
import { question, type Wanted } from '../ask/index.ts';
import { jobs } from '../workers/index.ts';
import type { LiveProof } from './answer.ts';

/** What a worker should prove about a level. */
export interface ProofQuestion {
  readonly level: Level;
  readonly terms: Terms;
  /** Indices of the minerals that some run collects, which need no proof. null: the page does not know. */
  readonly collected: readonly number[] | null;
}

/** What a worker should prove about the level; null: the runs reach everything, or checks are off. */
export function toProve(proof: LiveProof): ProofQuestion | null {
  const { level, terms, verdict, run, limit } = proof;
  if (limit === 'unchecked') return null;
  if (verdict === 'completable' && run.minerals.length === level.minerals.length) return null;
  return { level, terms, collected: proof.findings?.collected ?? null };
}

/** What a worker should simulate because the page left it out; null: nothing. */
export const toPlay = ({
  level,
  terms,
  limit,
}: Pick<LiveProof, 'level' | 'terms' | 'limit'>): { readonly level: Level; readonly terms: Terms } | null =>
  limit === null || limit === 'unchecked' ? null : { level, terms };

/** The level without its runs, as workers get it. */
export const withoutRuns = (level: Level): Level => ({ ...level, runs: [] });

/** A run of a level whose slack is asked for. */
export interface SlackOf {
  /** The same object as long as the answer is the same. */
  readonly of: object;
  readonly level: Level;
  readonly terms: Terms;
  readonly holds: readonly Hold[];
  readonly goal: Goal;
}

/** How far each press and release of a run may slip alone. */
export const slackQuestion = question({
  job: jobs.slack,
  request: ({ level, terms, holds, goal }: SlackOf) => ({ level: withoutRuns(level), terms, holds, goal }),
  follows: {
    wait: { rest: 300 },
    of: (wanted: Wanted<SlackOf>) => wanted.getState(),
    same: (asked, now) => asked.of === now.of && asked.holds.join() === now.holds.join(),
    on: (wanted) => [wanted.subscribe],
  },
});
