import { joinHolds } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { finish, type Steps } from '../../steps.ts';
import { advanceTo, isSuccess, type Trials } from './trials.ts';

/** So few that one step takes a few milliseconds. */
const COMBINATIONS_A_STEP = 500;

/** Stands for a press before, or a release after, every edge of a cluster. */
const FAR = 1e9;

/**
 * A group of edges that shifts can bring out of order, so that they are shifted together. Between two clusters the button is in
 * a known state whatever the shifts.
 */
export interface Cluster {
  /** Whether the button is held before the first of these edges. */
  readonly heldBefore: boolean;
  /**
   * Every different way in which the game may read the shifted edges: ascending ticks at which the button changes. Extreme
   * shifts come first.
   */
  readonly ways: readonly (readonly number[])[];
}

/** What a {@link ShiftBox} has found: a run that fails, that none fails, or that there is more to try. */
export type BoxResult = readonly Hold[] | 'proved' | 'unfinished';

/**
 * Tries all combinations of shifts of every edge by up to k ticks, as many per call as the caller allows. It works depth first:
 * each combination continues from the state at the end of its common beginning with the one before.
 */
export class ShiftBox {
  private readonly trials: Trials;
  private readonly clusters: readonly Cluster[];
  /** For each depth: the state before the cluster, the index of the way to try next, and the way taken. */
  private readonly states: Float64Array[];
  private readonly next: number[] = [0];
  private readonly chosen: (readonly number[])[] = [];
  private depth = 0;

  /** @param clusters at least one, from {@link clustersOf} */
  constructor(trials: Trials, clusters: readonly Cluster[]) {
    this.trials = trials;
    this.clusters = clusters;
    trials.simulation.reset();
    this.states = [trials.simulation.snapshot()];
  }

  /** Continues until one run fails, all have succeeded, or `maxRuns` more have been played. */
  run(maxRuns: number): BoxResult {
    const { trials, clusters, states, next, chosen } = this;
    const { simulation, maxTicks } = trials;
    const until = trials.runs + maxRuns;
    while (this.depth >= 0) {
      const { depth } = this;
      const { ways, heldBefore } = clusters[depth];
      if (next[depth] === ways.length) {
        this.depth--;
        continue;
      }
      if (trials.runs >= until) return 'unfinished';
      const way = ways[next[depth]++];
      simulation.restore(states[depth]);
      let held = heldBefore;
      for (const tick of way) {
        advanceTo(trials, Math.min(tick, maxTicks), held);
        held = !held;
      }
      chosen[depth] = way;
      chosen.length = depth + 1;
      // A run that has ended does not depend on the remaining edges.
      if (simulation.ending === null && depth + 1 < clusters.length) {
        states[depth + 1] = simulation.snapshot(states[depth + 1]);
        next[depth + 1] = 0;
        this.depth++;
        continue;
      }
      // The last edge is always a release.
      advanceTo(trials, maxTicks, false);
      if (!isSuccess(trials, () => this.played())) return this.played();
    }
    return 'proved';
  }

  /** The run that was played last. */
  private played(): Hold[] {
    const ticks = this.chosen.flat();
    if (ticks.length % 2 === 1) ticks.push(this.trials.maxTicks);
    const holds: Hold[] = [];
    for (let i = 0; i < ticks.length; i += 2) holds.push([ticks[i], ticks[i + 1]]);
    return holds;
  }
}

/** All shifts of up to k ticks, the most likely to fail first. */
export function shiftsUpTo(k: number): number[] {
  const shifts = [0];
  for (let by = 1; by <= k; by++) shifts.unshift(-by, by);
  return shifts;
}

/**
 * Lists what the game may read when every edge is shifted by one of `shifts`.
 * @param holds sorted and disjoint, at least one
 * @param k the largest shift either way, ticks
 * @param shifts the shifts to combine, ticks
 * @param maxWays the most combinations of one cluster
 * @returns the clusters in order, or null when one of them has more than `maxWays` combinations
 */
export const clustersOf = (holds: readonly Hold[], k: number, shifts: readonly number[], maxWays: number): Cluster[] | null =>
  finish(clustersInSteps(holds, k, shifts, maxWays));

/** {@link clustersOf}, a few combinations per step. */
export function* clustersInSteps(
  holds: readonly Hold[],
  k: number,
  shifts: readonly number[],
  maxWays: number,
): Steps<Cluster[] | null> {
  const edges = holds.flat();
  const clusters: Cluster[] = [];
  for (let first = 0; first < edges.length; ) {
    let last = first;
    while (last + 1 < edges.length && edges[last + 1] - edges[last] <= 2 * k) last++;
    const ways = yield* waysOf(edges, first, last, shifts, maxWays);
    if (ways === null) return null;
    clusters.push({ heldBefore: first % 2 === 1, ways });
    first = last + 1;
  }
  return clusters;
}

/**
 * Every way in which the game may read the edges from `first` to `last`; null when there are more than `maxWays` combinations.
 */
function* waysOf(
  edges: readonly number[],
  first: number,
  last: number,
  shifts: readonly number[],
  maxWays: number,
): Steps<number[][] | null> {
  const count = last - first + 1;
  let combinations = 1;
  for (let i = 0; i < count; i++) {
    combinations *= shifts.length;
    if (combinations > maxWays) return null;
  }
  const ways = new Map<string, number[]>();
  for (let c = 0; c < combinations; c++) {
    if (c % COMBINATIONS_A_STEP === COMBINATIONS_A_STEP - 1) yield null;
    const moved: number[] = first % 2 === 1 ? [-FAR] : [];
    for (let i = 0, rest = c; i < count; i++) {
      moved.push(Math.max(0, edges[first + i] + shifts[rest % shifts.length]));
      rest = Math.floor(rest / shifts.length);
    }
    if (last % 2 === 0) moved.push(FAR);
    const pairs: Hold[] = [];
    for (let i = 0; i < moved.length; i += 2) pairs.push([moved[i], moved[i + 1]]);
    const read = joinHolds(pairs)
      .flat()
      .filter((tick) => tick > -FAR && tick < FAR);
    const key = read.join();
    if (!ways.has(key)) ways.set(key, read);
  }
  return [...ways.values()];
}
