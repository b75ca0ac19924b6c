import { type Allowed, adjustmentOf, type Problem, type SeverityMap } from '../../schema/index.ts';

/**
 * Decides which problems count: what a configuration says about their severity, and what a level allows. Verdicts are not
 * decided here, and nothing here makes a level completable.
 *
 * @module
 */

/** What is said about problems besides the check itself. */
interface Policy {
  /** The severities that a configuration sets, by code. */
  readonly severity: SeverityMap;
  /** What the level allows, by code. */
  readonly allow: Allowed;
}

/** The problems that count, and how many do not. */
interface Judged<P> {
  /** The problems that are reported, in their order, with their severity. */
  readonly problems: readonly P[];
  /** How many the level allows. */
  readonly allowed: number;
}

/** Whether a problem can be changed: an error that decides the verdict cannot. */
function isAdjustable({ code, severity }: Pick<Problem, 'code' | 'severity'>): boolean {
  const adjustment = adjustmentOf(code);
  if (adjustment === null || adjustment.severity === 'fixed') return false;
  return adjustment.severity === 'free' || severity === 'warning';
}

/**
 * Applies a policy to the problems of a level. What the level allows is left out, whatever the configuration says about it. An
 * error that decides the verdict stays an error.
 *
 * @param problems - the problems as the check found them
 * @param policy - what the configuration and the level say
 * @returns the problems that count; without any policy, the same list
 */
export function applyPolicy<P extends Pick<Problem, 'code' | 'severity'>>(
  problems: readonly P[],
  { severity, allow }: Policy,
): Judged<P> {
  let allowed = 0;
  const kept = problems.flatMap((problem): P[] => {
    if (!isAdjustable(problem)) return [problem];
    if (adjustmentOf(problem.code)?.allow && Object.hasOwn(allow, problem.code)) {
      allowed++;
      return [];
    }
    const wanted = Object.hasOwn(severity, problem.code) ? severity[problem.code as keyof SeverityMap] : undefined;
    if (wanted === 'off') return [];
    return [wanted === undefined || wanted === problem.severity ? problem : { ...problem, severity: wanted }];
  });
  return { problems: kept, allowed };
}
