import { maxTicksOf, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { type Candidate, createReplay, type Goal, holdsOf } from '../../verified-run.ts';
import type { Effort } from '../explore/index.ts';

/** Limits for {@link cleanRun}. */
export interface CleanOptions {
  /** The most replays it may take; 400 by default. */
  readonly maxRuns?: number;
  /** The longest the run may last, ticks; that of the scene by default. */
  readonly maxTicks?: number;
}

/** A simplified run and what it cost to find it. */
export interface Cleaned {
  /** The simplified run. */
  readonly run: Candidate;
  /** The replays it took and the ticks they simulated. */
  readonly effort: Effort;
}

/**
 * Presses and releases are rounded to multiples of these where the run still succeeds, ticks: half a second, a tenth of a
 * second.
 */
const GRIDS = [30, 6] as const;

/** The most by which a pause or hold is shortened in one attempt, ticks. */
const LONGEST_CUT = 256;

/**
 * Simplifies a run that meets its goal: it drops needless presses, joins holds, shortens pauses and holds, and rounds presses
 * and releases. A replay confirms every change. The result has no more presses than the original and ends no later.
 * @param scene the compiled level
 * @param holds the original run, [press, release) in ticks
 * @param goal what the run has to achieve, before and after
 * @param options limits on the work and on the length of the run
 * @returns the simplified run, or null when the original does not meet the goal
 */
export function cleanRun(scene: Scene, holds: readonly Hold[], goal: Goal, options: CleanOptions = {}): Cleaned | null {
  const { maxRuns = 400, maxTicks = maxTicksOf(scene.terms) } = options;
  const replay = createReplay(scene, goal, maxTicks);
  const original = replay.play(holds);
  if (original === null) return null;
  let runs = 1;
  let best = original;

  /** Accepts the holds as the new best run if they meet the goal by tick `by` with at most this many presses. */
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
        const edges = best.holds.flat();
        // First move this edge and all later ones, then this edge alone.
        if (attempt(holdsOf(earlierFrom(edges, i, cut)), best.tick - 1, best.holds.length)) continue;
        attempt(holdsOf(edges.map((edge, k) => (k === i ? edge - cut : edge))), best.tick - 1, best.holds.length);
      }
    }
    return best.tick < before;
  };

  const round = (): void => {
    for (const grid of GRIDS) {
      for (let i = 0; i < 2 * best.holds.length; i++) {
        const edges = best.holds.flat();
        // An edge that is a multiple of a coarser grid stays where it is.
        if (GRIDS.some((wider) => wider >= grid && edges[i] % wider === 0)) continue;
        attempt(holdsOf(edges.map((edge, k) => (k === i ? rounded(edge, grid) : edge))), original.tick, best.holds.length);
      }
    }
  };

  while (dropPresses() || shorten());
  round();
  return { run: best, effort: { runs, ticks: replay.ticks } };
}

/** Removes hold `i`. */
const withoutHold = (holds: readonly Hold[], i: number): Hold[] => holds.filter((_, k) => k !== i);

/** Extends hold `i` to the end of the next one. */
const joined = (holds: readonly Hold[], i: number): Hold[] => [
  ...holds.slice(0, i),
  [holds[i][0], holds[i + 1][1]],
  ...holds.slice(i + 2),
];

/** Moves edge `i` and all later ones earlier by this many ticks. */
const earlierFrom = (edges: readonly number[], i: number, ticks: number): number[] =>
  edges.map((edge, k) => (k >= i ? edge - ticks : edge));

/** The multiple of `grid` nearest to a tick. */
const rounded = (tick: number, grid: number): number => Math.round(tick / grid) * grid;
