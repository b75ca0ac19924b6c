import type { Outcome } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { compareHolds } from './compare-holds.ts';
import { firstDifference } from './first-difference.ts';

/** What is compared of a run. */
export interface ComparableRun {
  /** Sorted and disjoint. */
  readonly holds: readonly Hold[];
  readonly outcome: Outcome;
  /** s */
  readonly time: number;
  /** How many different minerals it collects. */
  readonly minerals: number;
  /** The least distance to a hazard, px; null if there is none. */
  readonly clearance: number | null;
  /** The smallest room of a press or release, both directions together, ticks; null if it is not known or the run fails. */
  readonly slack: number | null;
}

/** A hold of the one run, of the other, or of both. */
export interface HoldPair {
  readonly one: Hold | null;
  readonly other: Hold | null;
  /** How much later the other run presses and releases, ticks; null unless both have the hold. */
  readonly press: number | null;
  readonly release: number | null;
}

/** Which of two runs does better; null: neither, or it can't be said. */
export type Better = 'one' | 'other' | null;

/** A figure of both runs. */
export interface Comparison<T> {
  readonly one: T;
  readonly other: T;
  readonly better: Better;
}

/** The difference of two runs. */
export interface RunsDifference {
  /** The first tick at which the scripts differ; null: they are the same. */
  readonly from: number | null;
  /** In order of time. */
  readonly holds: readonly HoldPair[];
  readonly outcome: Comparison<Outcome>;
  /** Less is better where both complete the level. */
  readonly time: Comparison<number>;
  readonly minerals: Comparison<number>;
  readonly clearance: Comparison<number | null>;
  readonly slack: Comparison<number | null>;
}

/** @param sign 1 if more is better, -1 if less is */
function compared<T extends number | null>(one: T, other: T, sign: 1 | -1): Comparison<T> {
  const by = one === null || other === null ? 0 : sign * (one - other);
  return { one, other, better: by > 0 ? 'one' : by < 0 ? 'other' : null };
}

/** All holds of both runs; those of each are in order of time. */
function pairsOf(one: readonly Hold[], other: readonly Hold[]): HoldPair[] {
  const all: HoldPair[] = [];
  let [i, j] = [0, 0];
  const alone = (untilOne: number, untilOther: number) => {
    while (i < untilOne || j < untilOther) {
      const isOne = j >= untilOther || (i < untilOne && one[i][0] <= other[j][0]);
      if (isOne) all.push({ one: one[i++], other: null, press: null, release: null });
      else all.push({ one: null, other: other[j++], press: null, release: null });
    }
  };
  for (const [a, b] of compareHolds(one, other).pairs) {
    alone(a, b);
    all.push({ one: one[a], other: other[b], press: other[b][0] - one[a][0], release: other[b][1] - one[a][1] });
    [i, j] = [a + 1, b + 1];
  }
  alone(one.length, other.length);
  return all;
}

/** Compares two runs of a level. */
export function compareRuns(one: ComparableRun, other: ComparableRun): RunsDifference {
  const from = firstDifference(one.holds, other.holds);
  const [a, b] = [one.outcome === 'completed', other.outcome === 'completed'];
  const time = compared(one.time, other.time, -1);
  return {
    from: Number.isFinite(from) ? from : null,
    holds: pairsOf(one.holds, other.holds),
    outcome: { one: one.outcome, other: other.outcome, better: a === b ? null : a ? 'one' : 'other' },
    time: a && b ? time : { ...time, better: null },
    minerals: compared(one.minerals, other.minerals, 1),
    clearance: compared(one.clearance, other.clearance, 1),
    slack: compared(one.slack, other.slack, 1),
  };
}
