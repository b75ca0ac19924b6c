import type { Searched } from '../../check/index.ts';
import { isAccuracyName, type Scene, TICK_RATE } from '../../engine/index.ts';
import { createAnytimeProof, createSolver, type Proof } from '../../solver/index.ts';
import type { CheckSettings, SearchSettings } from './checked-level.ts';

/** Simulated ticks between two looks at the clock. */
const SLICE = 50_000;

/** What a search found. */
export interface LevelSearch extends Searched {
  /** A proof that there is no run, found beside the search; null if there is none. */
  readonly impossible: Proof | null;
  /** Whether the clock ended it: another search with the same settings may find more or less. */
  readonly isOutOfTime: boolean;
}

/**
 * Searches for a run that completes a level: for any run, or if slack is required, for the most robust one. As long as there is
 * none, half of the work goes into proofs with ever finer sets.
 * Blocks the calling thread for as long as the limits allow.
 */
export function searchLevel(
  scene: Scene,
  { limits, seed }: SearchSettings,
  { accuracy, maxTime, requireSlack }: CheckSettings,
): LevelSearch {
  const objective = requireSlack === null ? 'first' : 'robust';
  const maxTicks = Math.round(maxTime * TICK_RATE);
  const solver = createSolver(scene, { objective, seed, maxTicks });
  const end = limits.budget === null ? Number.POSITIVE_INFINITY : performance.now() + 1000 * limits.budget;
  const most = limits.effort ?? Number.POSITIVE_INFINITY;
  const isLate = (): boolean => performance.now() >= end;
  const proving = isAccuracyName(accuracy.name)
    ? createAnytimeProof(scene.level, { accuracy: accuracy.name, maxTicks, isStopped: isLate })
    : null;
  const spent = (): number => solver.effort.ticks + (proving?.ticks ?? 0);
  const isProving = (): boolean => solver.best === null && proving !== null && !proving.finished;
  const isOver = (): boolean => (solver.best === null && proving?.proof != null) || solver.finished;
  // what the proofs may have spent so far
  let given = 0;
  while (!isOver() && spent() < most && !isLate()) {
    solver.advance(Math.min(SLICE, most - spent()));
    if (!isProving()) continue;
    const may = Math.min(solver.effort.ticks, (proving?.ticks ?? 0) + Math.max(0, most - spent()));
    proving?.advance(Math.max(0, may - given));
    given = Math.max(given, may);
  }
  const { best, effort, closest } = solver;
  const impossible = best === null ? (proving?.proof ?? null) : null;
  const isOutOfTime = !isOver() && spent() < most;
  return {
    found: best?.holds ?? null,
    impossible,
    effort: { runs: effort.runs, ticks: effort.ticks + (proving?.ticks ?? 0) },
    closest,
    isOutOfTime,
  };
}
