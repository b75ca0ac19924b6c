import { wilsonInterval } from '../../solver/measure/robustness/index.ts';
import type { Attempt } from './attempt.ts';

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

/** What an edge of a play costs that has no partner, ticks. */
const EXTRA = 60;

/** What an edge of the reference costs that the play left out, ticks. */
const LEFT_OUT = 30;

/**
 * Finds which edge of a play stands for which edge of a reference run: the cheapest alignment (S. B. Needleman, C. D. Wunsch,
 * 1970) that pairs a press with a press and a release with a release, in order. A pair costs the ticks between both; an edge
 * without a partner costs {@link EXTRA} or {@link LEFT_OUT}, but for the edges of the reference after the last pair: the play did
 * not come so far.
 * @param reference the ticks at which the reference changes the button; the first is a press
 * @param edges those of the play
 * @returns for each edge of the reference the index of its partner, or -1
 */
export function alignEdges(reference: readonly number[], edges: readonly number[]): Int32Array {
  const [n, m] = [reference.length, edges.length];
  const width = m + 1;
  const cost = new Float64Array((n + 1) * width);
  for (let j = 1; j <= m; j++) cost[j] = EXTRA * j;
  for (let i = 1; i <= n; i++) {
    cost[i * width] = LEFT_OUT * i;
    for (let j = 1; j <= m; j++) {
      const alone = Math.min(LEFT_OUT + cost[(i - 1) * width + j], EXTRA + cost[i * width + j - 1]);
      cost[i * width + j] = Math.min(alone, pairCost(reference, edges, i, j) + cost[(i - 1) * width + j - 1]);
    }
  }
  const partners = new Int32Array(n).fill(-1);
  let [i, j] = [0, m];
  for (let end = 1; end <= n; end++) if (cost[end * width + m] < cost[i * width + m]) i = end;
  while (i > 0 && j > 0) {
    const here = cost[i * width + j];
    if (here === pairCost(reference, edges, i, j) + cost[(i - 1) * width + j - 1]) {
      i--;
      j--;
      partners[i] = j;
    } else if (here === EXTRA + cost[i * width + j - 1]) j--;
    else i--;
  }
  return partners;
}

/** What it costs to pair edge `i` of the reference with edge `j` of the play, both from 1. */
function pairCost(reference: readonly number[], edges: readonly number[], i: number, j: number): number {
  if ((i - j) % 2 !== 0) return Number.POSITIVE_INFINITY;
  return Math.abs(reference[i - 1] - edges[j - 1]);
}

/** The middle of a sample and the middles of its halves. */
export interface Quartiles {
  /** How many numbers the sample has. */
  readonly count: number;
  /** A quarter of the numbers are below. */
  readonly low: number;
  /** Half of the numbers are below. */
  readonly median: number;
  /** Three quarters of the numbers are below. */
  readonly high: number;
}

/** Whole numbers, counted: its size grows with the number of different numbers only. */
export class Tally {
  private readonly counts = new Map<number, number>();
  count = 0;

  add(value: number): void {
    this.counts.set(value, (this.counts.get(value) ?? 0) + 1);
    this.count++;
  }

  /**
   * The quartiles, linear between the two numbers that are nearest in rank (definition 7 of R. J. Hyndman and Y. Fan, Sample
   * quantiles in statistical packages, 1996); null if there is no number.
   */
  quartiles(): Quartiles | null {
    if (this.count === 0) return null;
    const sorted = [...this.counts].sort(([a], [b]) => a - b);
    const at = (rank: number): number => {
      let before = 0;
      for (const [value, count] of sorted) {
        before += count;
        if (rank < before) return value;
      }
      return sorted[sorted.length - 1][0];
    };
    const quantile = (part: number): number => {
      const rank = part * (this.count - 1);
      const [below, above] = [at(Math.floor(rank)), at(Math.ceil(rank))];
      return below + (rank - Math.floor(rank)) * (above - below);
    };
    return { count: this.count, low: quantile(0.25), median: quantile(0.5), high: quantile(0.75) };
  }
}
