import type { Attempt, FailureCause } from './attempt.ts';

/** How many attempts fail for one cause. */
export interface CauseStatistics {
  /** Why they fail. */
  readonly cause: FailureCause;
  /** How many fail. */
  readonly count: number;
  /** Their share of all failures, 0 to 1. */
  readonly share: number;
}

/** The attempts that fail for one cause. */
interface CauseGroup {
  readonly cause: FailureCause;
  readonly attempts: Attempt[];
}

/** The attempts that fail, by a name of their cause. */
export function byCause(attempts: readonly Attempt[]): Map<string, CauseGroup> {
  const groups = new Map<string, CauseGroup>();
  for (const attempt of attempts) {
    const { cause } = attempt;
    if (cause === null) continue;
    const key = `${cause.kind} ${cause.index ?? ''}`;
    const known = groups.get(key);
    if (known === undefined) groups.set(key, { cause, attempts: [attempt] });
    else known.attempts.push(attempt);
  }
  return groups;
}

/** Counts why attempts fail, the most frequent cause first. */
export function causesOf(attempts: readonly Attempt[]): CauseStatistics[] {
  const groups = [...byCause(attempts)].map(([key, { cause, attempts: own }]) => ({ key, cause, count: own.length }));
  const failures = groups.reduce((sum, { count }) => sum + count, 0);
  groups.sort((a, b) => b.count - a.count || (a.key < b.key ? -1 : 1));
  return groups.map(({ cause, count }) => ({ cause, count, share: count / failures }));
}
