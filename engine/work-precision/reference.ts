import type { Hold, Level } from '../../schema/basics/index.ts';
import type { Accuracy } from '../accuracy.ts';
import { compile } from '../compile.ts';
import { TICK } from '../constants.ts';
import { createSimulation } from '../simulate.ts';
import type { Outcome } from '../simulation.ts';
import { TOLERANCES } from './methods.ts';
import { largestDistance, type Path, pathOf } from './path.ts';

/** The run that others are compared with. */
export interface Reference {
  /** Tolerance, px per second: a thousandth of the tightest one that is measured. */
  readonly tolerance: number;
  readonly path: Path;
  readonly outcome: Outcome;
  /** When it ended, s. */
  readonly time: number;
  /**
   * How exactly the reference itself is known, px: its largest distance to the same run at two looser tolerances, which are
   * still tighter than all that are measured. At these tolerances the rounding of doubles remains, magnified by the run. An
   * error below this floor means no more than that.
   */
  readonly floor: number;
}

export const REFERENCE_TOLERANCE = TOLERANCES[TOLERANCES.length - 1] / 1000;

/** Looser tolerances that show how far the reference can be trusted. */
const DOUBTS = [3 * REFERENCE_TOLERANCE, 10 * REFERENCE_TOLERANCE];

const swept = (tolerance: number): Accuracy => ({
  name: 'reference',
  integrator: 'taylor',
  rate: null,
  tolerance,
  contact: 'swept',
});

/** Plays holds at the reference's tolerance and estimates how exact the result is. */
export function referenceOf(level: Level, holds: readonly Hold[], maxTicks: number): Reference {
  const play = (tolerance: number) => pathOf(createSimulation(compile(level, swept(tolerance))), holds, maxTicks);
  const path = play(REFERENCE_TOLERANCE);
  return {
    tolerance: REFERENCE_TOLERANCE,
    path,
    ...endOf(path, maxTicks),
    floor: Math.max(...DOUBTS.map((tolerance) => largestDistance(path, play(tolerance)))),
  };
}

/** How and when a run ended; time in s. */
export function endOf(path: Path, maxTicks: number): { outcome: Outcome; time: number } {
  return { outcome: path.ending?.outcome ?? 'timeout', time: path.ending?.time ?? maxTicks * TICK };
}
