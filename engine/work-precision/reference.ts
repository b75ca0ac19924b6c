import type { Hold, Level } from '../../schema/index.ts';
import type { Accuracy } from '../accuracy.ts';
import { compile } from '../compile.ts';
import { TICK } from '../constants.ts';
import { createSimulation } from '../simulate.ts';
import type { Outcome } from '../simulation.ts';
import { TOLERANCES } from './methods.ts';
import { largestDistance, type Path, pathOf } from './path.ts';

/** What runs are compared with. */
export interface Reference {
  /** px a second; a thousandth of the tightest that is measured */
  readonly tolerance: number;
  readonly path: Path;
  readonly outcome: Outcome;
  /** s */
  readonly time: number;
  /**
   * How well the reference itself is known, px: its largest distance to the same run at two looser tolerances, still
   * tighter than any that is measured. At these tolerances it is the rounding of doubles, magnified by the run, that is
   * left. An error below the floor means nothing more than that.
   */
  readonly floor: number;
}

export const REFERENCE_TOLERANCE = TOLERANCES[TOLERANCES.length - 1] / 1000;

/** Looser tolerances that show how far the reference may be trusted. */
const DOUBTS = [3 * REFERENCE_TOLERANCE, 10 * REFERENCE_TOLERANCE];

const swept = (tolerance: number): Accuracy => ({
  name: 'reference',
  integrator: 'taylor',
  rate: null,
  tolerance,
  contact: 'swept',
});

/** Plays a script at the reference's tolerance and estimates what that is worth. */
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

/** How a run ended and when, s. */
export function endOf(path: Path, maxTicks: number): { outcome: Outcome; time: number } {
  return { outcome: path.ending?.outcome ?? 'timeout', time: path.ending?.time ?? maxTicks * TICK };
}
