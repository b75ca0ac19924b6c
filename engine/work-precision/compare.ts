import type { Hold, Level } from '../../schema/index.ts';
import type { Accuracy } from '../accuracy.ts';
import { compile } from '../compile.ts';
import { createSimulation } from '../simulate.ts';
import type { Outcome } from '../simulation.ts';
import { largestDistance, type Path, pathOf } from './path.ts';
import { endOf, type Reference } from './reference.ts';

/** How a run at one setting differs from the reference. */
export interface Deviation {
  /** Largest distance to the reference at ticks before the earlier of both ends, px. */
  readonly error: number;
  readonly outcome: Outcome;
  /** s */
  readonly time: number;
  /** The outcome is the reference's. Where it isn't the error says little: the runs part. */
  readonly sameVerdict: boolean;
}

/** Compares a path, however it was made, with the reference of the same script. */
export function deviationOf(path: Path, reference: Reference, maxTicks: number): Deviation {
  const { outcome, time } = endOf(path, maxTicks);
  return {
    error: largestDistance(path, reference.path),
    outcome,
    time,
    sameVerdict: outcome === reference.outcome,
  };
}

/** Plays a script at one setting and compares it with the reference. */
export function compareWith(
  reference: Reference,
  level: Level,
  holds: readonly Hold[],
  accuracy: Accuracy,
  maxTicks: number,
): Deviation {
  return deviationOf(pathOf(createSimulation(compile(level, accuracy)), holds, maxTicks), reference, maxTicks);
}
