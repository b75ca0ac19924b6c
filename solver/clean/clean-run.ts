import type { Scene } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import type { Goal } from '../goal.ts';
import type { Effort } from '../search/index.ts';
import { type Candidate, createReplay, DEFAULT_MAX_TICKS } from '../verified-run.ts';
import { earlierFrom, edgesOf, holdsOf, joined, rounded, withoutHold } from './simpler-scripts.ts';

export interface CleanOptions {
  /** replays it may take; 400 when left out */
  readonly maxRuns?: number;
  /** how long the run may last, ticks; 3600 when left out */
  readonly maxTicks?: number;
}

/** A run made simpler, and what that took. */
export interface Cleaned {
  readonly run: Candidate;
  readonly effort: Effort;
}

/** Edges are rounded to multiples of half a second, or a tenth, where the run allows it, ticks. */
const GRIDS = [30, 6] as const;

/** The most that a pause or hold is shortened by at once, ticks. */
const LONGEST_CUT = 256;

/**
 * Makes a run that meets its goal simpler: presses that are not needed go, holds are joined, pauses and holds get shorter, edges
 * become round. Every step is verified by a replay. The result has no more presses than the run it came from, and ends no later.
 * @returns null when the run does not meet the goal to begin with
 */
export function cleanRun(scene: Scene, holds: readonly Hold[], goal: Goal, options: CleanOptions = {}): Cleaned | null {
  const { maxRuns = 400, maxTicks = DEFAULT_MAX_TICKS } = options;
  const replay = createReplay(scene, goal, maxTicks);
  const original = replay.play(holds);
  if (original === null) return null;
  let runs = 1;
  let best = original;

  /** Takes a script over when it meets the goal by tick `by` with at most so many presses. */
  const attempt = (script: readonly Hold[] | null, by: number, presses: number): boolean => {
    if (script === null || runs >= maxRuns) return false;
    runs++;
    const run = replay.play(script, by + 1);
    if (run === null || run.tick > by || run.holds.length > presses) return false;
    best = run;
    return true;
  };

  const dropPresses = (): boolean => {
    const before = best.holds.length;
    for (let i = best.holds.length - 1; i >= 0; i--) {
      if (i < best.holds.length) attempt(withoutHold(best.holds, i), original.tick, best.holds.length - 1);
      if (i + 1 < best.holds.length) attempt(joined(best.holds, i), original.tick, best.holds.length - 1);
    }
    return best.holds.length < before;
  };

  const shorten = (): boolean => {
    const before = best.tick;
    for (let cut = LONGEST_CUT; cut >= 1; cut /= 2) {
      for (let i = 0; i < 2 * best.holds.length; i++) {
        const edges = edgesOf(best.holds);
        // all that follows comes earlier, or this edge alone
        if (attempt(holdsOf(earlierFrom(edges, i, cut)), best.tick - 1, best.holds.length)) continue;
        attempt(holdsOf(edges.map((edge, k) => (k === i ? edge - cut : edge))), best.tick - 1, best.holds.length);
      }
    }
    return best.tick < before;
  };

  const round = (): void => {
    for (const grid of GRIDS) {
      for (let i = 0; i < 2 * best.holds.length; i++) {
        const edges = edgesOf(best.holds);
        // what is round on a wider grid stays so
        if (GRIDS.some((wider) => wider >= grid && edges[i] % wider === 0)) continue;
        attempt(holdsOf(edges.map((edge, k) => (k === i ? rounded(edge, grid) : edge))), original.tick, best.holds.length);
      }
    }
  };

  while (dropPresses() || shorten());
  round();
  return { run: best, effort: { runs, ticks: replay.ticks } };
}
