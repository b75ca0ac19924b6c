import type { Searched } from '../../check/index.ts';
import { type Scene, TICK_RATE } from '../../engine/index.ts';
import { createSolver } from '../../solver/index.ts';
import type { CheckSettings, SearchSettings } from './checked-level.ts';

/** Simulated ticks between two looks at the clock. */
const SLICE = 50_000;

/** What a search found. */
export interface LevelSearch extends Searched {
  /** Whether the clock ended it: another search with the same settings may find more or less. */
  readonly isOutOfTime: boolean;
}

/**
 * Searches for a run that completes a level: for any run, or if slack is required, for the most robust one.
 * Blocks the calling thread for as long as the limits allow.
 */
export function searchLevel(
  scene: Scene,
  { limits, seed }: SearchSettings,
  { maxTime, requireSlack }: CheckSettings,
): LevelSearch {
  const objective = requireSlack === null ? 'first' : 'robust';
  const solver = createSolver(scene, { objective, seed, maxTicks: Math.round(maxTime * TICK_RATE) });
  const end = limits.budget === null ? Number.POSITIVE_INFINITY : performance.now() + 1000 * limits.budget;
  const most = limits.effort ?? Number.POSITIVE_INFINITY;
  while (!solver.finished && solver.effort.ticks < most && performance.now() < end) {
    solver.advance(Math.min(SLICE, most - solver.effort.ticks));
  }
  const { best, effort, closest } = solver;
  const isOutOfTime = !solver.finished && effort.ticks < most;
  return { found: best?.holds ?? null, effort: { ...effort }, closest, isOutOfTime };
}
