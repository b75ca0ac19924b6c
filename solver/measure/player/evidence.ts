import { TICK_RATE } from '../../../engine/index.ts';
import { normalBeyondHalf } from '../robustness/index.ts';
import { logarithm } from './elementary.ts';
import { deviationOf, practise, type TimedRun } from './player.ts';

/** An attempt of a player, compared with the run that it aims at. */
export interface ObservedAttempt {
  /** How much later than the run it has each press and release, ticks; null where it has none that can be paired. */
  readonly shifts: readonly (number | null)[];
  /** The tick at which it ended. */
  readonly end: number;
  /** Whether it failed. */
  readonly failed: boolean;
}

const MS_PER_TICK = 1000 / TICK_RATE;

/**
 * The share of presses and releases that follow no plan: a slip, or another way through the level. Without it a single one would
 * rule out every sensible amount of noise (F. A. Wichmann and N. J. Hill, The psychometric function, 2001).
 */
const SLIPS = 0.01;

/** A slip may be anywhere within this many ticks of the plan, earlier or later. */
const SLIP_REACH = 90;

/** Beyond so many standard deviations nothing is likely. */
const REACH = 6.5;
const PER_DEVIATION = 500;

/** The normal distribution function minus 1/2 at multiples of 1 / {@link PER_DEVIATION}. */
const TABLE = Float64Array.from({ length: REACH * PER_DEVIATION + 1 }, (_, i) => normalBeyondHalf(i / PER_DEVIATION));

function normal(x: number): number {
  const at = Math.min(Math.abs(x), REACH - 1e-9) * PER_DEVIATION;
  const i = Math.floor(at);
  const value = TABLE[i] + (at - i) * (TABLE[i + 1] - TABLE[i]);
  return x < 0 ? 0.5 - value : 0.5 + value;
}

/** One press or release: its error lay between two values, ms; `high` is infinite where it had not come when the attempt ended. */
interface Term {
  readonly edge: number;
  readonly practice: number;
  readonly low: number;
  readonly high: number;
}

/** What the attempts of one player say about the player's factor. */
export class Evidence {
  private readonly terms: Term[] = [];

  /** @param attempts the player's attempts, in order */
  constructor(
    private readonly run: TimedRun,
    attempts: readonly ObservedAttempt[],
  ) {
    const practice = new Int32Array(run.edges.length);
    for (const { shifts, end, failed } of attempts) {
      const reached = 1 + shifts.findLastIndex((shift) => shift !== null);
      for (let edge = 0; edge <= Math.min(reached, run.edges.length - 1); edge++) {
        const inherited = run.inherits[edge] === 1 ? shifts[edge - 1] : 0;
        if (inherited === null) continue;
        const shift = edge === reached ? end - run.edges[edge] : shifts[edge];
        if (shift === null) continue;
        const low = (shift - inherited - 0.5) * MS_PER_TICK;
        const high = edge === reached ? Number.POSITIVE_INFINITY : low + MS_PER_TICK;
        this.terms.push({ edge, practice: practice[edge], low, high });
      }
      practise(practice, reached, failed);
    }
  }

  /** How many presses and releases were seen. */
  get seen(): number {
    return this.terms.filter(({ high }) => high !== Number.POSITIVE_INFINITY).length;
  }

  /**
   * The log-likelihood for each factor.
   * @param left see `practiceTable`
   */
  curve(factors: Float64Array, left: Float64Array): Float64Array {
    const sums = new Float64Array(factors.length);
    for (const { edge, practice, low, high } of this.terms) {
      const deviation = deviationOf(this.run, edge, left[Math.min(practice, left.length - 1)], 1);
      const isOpen = high === Number.POSITIVE_INFINITY;
      const slip = isOpen ? SLIPS : SLIPS / (2 * SLIP_REACH + 1);
      for (let i = 0; i < factors.length; i++) {
        const scale = 1 / (deviation * factors[i]);
        const p = (isOpen ? 1 : normal(high * scale)) - normal(low * scale);
        sums[i] += logarithm((1 - SLIPS) * Math.max(0, p) + slip);
      }
    }
    return sums;
  }
}
