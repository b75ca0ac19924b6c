import type { Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import type { Goal } from '../../goal.ts';
import type { Closest, Effort } from '../../search/explore/index.ts';
import { createSolver } from '../../search/solve/index.ts';
import { verifyRun } from '../../verified-run.ts';

/** Runs that meet a goal, to be compared. */
export interface FoundRuns {
  /** The level's own runs that meet the goal, then those that the search found; no two are the same. */
  readonly runs: readonly (readonly Hold[])[];
  /** What the search has cost. */
  readonly effort: Effort;
  /** How near the search came to the black hole; null if nothing was simulated. */
  readonly closest: Closest | null;
}

/** How many different runs the search returns at most. */
const FOUND = 3;

/**
 * Finds the runs that forgive most, beginning with the level's own. Half of the effort is for that; the other half is spent only if
 * there is no run by then.
 * @param scene the compiled level
 * @param goal what a run has to achieve
 * @param options ticks to simulate at most, the seed of the search, and the longest that a run may last in ticks
 */
export function findRuns(
  scene: Scene,
  goal: Goal,
  options: {
    /** Ticks to simulate at most. */
    readonly effort: number;
    /** Seed of the search, a whole number. */
    readonly seed: number;
    /** The longest a run may last, ticks. */
    readonly maxTicks: number;
  },
): FoundRuns {
  const { effort, seed, maxTicks } = options;
  const known = scene.level.runs.map(({ holds }) => holds).filter((holds) => verifyRun(scene, holds, goal, maxTicks) !== null);
  const solver = createSolver(scene, { goal, seed, maxTicks, objective: 'robust', count: FOUND, known });
  solver.advance(Math.ceil(effort / 2));
  if (solver.best === null && known.length === 0) solver.advance(Math.floor(effort / 2));
  const runs = new Map([...known, ...solver.solutions.map(({ holds }) => holds)].map((holds) => [JSON.stringify(holds), holds]));
  return { runs: [...runs.values()], effort: solver.effort, closest: solver.closest };
}
