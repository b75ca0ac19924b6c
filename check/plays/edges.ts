import { wilsonInterval } from '../../solver/measure/robustness/index.ts';
import { alignEdges } from './alignment.ts';
import type { Attempt } from './attempt.ts';
import { type Quartiles, Tally } from './quartiles.ts';

/** What happens to attempts between one press or release of the reference run and the next. */
export interface EdgeStatistics {
  /** `start`: before the first press. */
  readonly type: 'start' | 'press' | 'release';
  /** Which hold of the reference run it begins or ends, from 0; 0 for the start. */
  readonly hold: number;
  /** When the reference run has it, ticks. */
  readonly tick: number;
  /** How many attempts came so far. */
  readonly reached: number;
  /** How many of them failed before the next press or release. */
  readonly failed: number;
  /** `failed` as a share of `reached`, 0 to 1; 0 if none came so far. */
  readonly share: number;
  /** Lower end of the 95 % confidence interval of `share` (Wilson's score interval). */
  readonly low: number;
  /** Upper end of it. */
  readonly high: number;
  /** How much later than the reference it is in attempts that succeed, ticks; negative for earlier. null if none has it. */
  readonly succeeding: Quartiles | null;
  /** The same in attempts that fail, then or later. */
  readonly failing: Quartiles | null;
}

/**
 * Says after which press or release of a reference run attempts fail.
 * @param reference the ticks at which the reference run changes the button
 * @param attempts the attempts
 * @returns the start, then each press and release of the reference run
 */
export function edgeStatistics(reference: readonly number[], attempts: Iterable<Attempt>): EdgeStatistics[] {
  const stages = [0, ...reference].map(() => ({ at: 0, failed: 0, succeeding: new Tally(), failing: new Tally() }));
  for (const { edges, cause } of attempts) {
    const partners = alignEdges(reference, edges);
    const reached = 1 + partners.findLastIndex((partner) => partner >= 0);
    stages[reached].at++;
    if (cause !== null) stages[reached].failed++;
    for (let i = 0; i < reached; i++) {
      if (partners[i] < 0) continue;
      const shift = edges[partners[i]] - reference[i];
      stages[i + 1][cause === null ? 'succeeding' : 'failing'].add(shift);
    }
  }
  let reached = 0;
  const rows: EdgeStatistics[] = [];
  for (let i = stages.length - 1; i >= 0; i--) {
    const { at, failed, succeeding, failing } = stages[i];
    reached += at;
    rows.push({
      type: i === 0 ? 'start' : i % 2 === 1 ? 'press' : 'release',
      hold: Math.max(0, i - 1) >> 1,
      tick: i === 0 ? 0 : reference[i - 1],
      reached,
      failed,
      share: reached === 0 ? 0 : failed / reached,
      ...wilsonInterval(failed, reached),
      succeeding: succeeding.quartiles(),
      failing: failing.quartiles(),
    });
  }
  return rows.reverse();
}
