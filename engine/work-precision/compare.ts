import type { Hold, Level } from '../../schema/basics/index.ts';
import type { Accuracy } from '../accuracy.ts';
import { compile } from '../compile.ts';
import { createSimulation } from '../simulate.ts';
import type { Outcome } from '../simulation.ts';
import { largestDistance, type Path, pathOf } from './path.ts';
import { endOf, type Reference } from './reference.ts';

/** How a run at one setting differs from the reference. */
export interface Deviation {
  /** Largest distance to the reference at the ticks before the earlier of both ends, px. */
  readonly error: number;
  readonly outcome: Outcome;
  /** When the run ended, s. */
  readonly time: number;
  /** Whether the outcome is that of the reference. If it is not, the runs diverge, and the error says little. */
  readonly sameVerdict: boolean;
}

/** Compares a path, from whatever engine, with the reference for the same holds. */
export function deviationOf(path: Path, reference: Reference, maxTicks: number): Deviation {
  const { outcome, time } = endOf(path, maxTicks);
  return {
    error: largestDistance(path, reference.path),
    outcome,
    time,
    sameVerdict: outcome === reference.outcome,
  };
}

/** Plays holds at one setting and compares the run with the reference. */
export function compareWith(
  reference: Reference,
  level: Level,
  holds: readonly Hold[],
  accuracy: Accuracy,
  maxTicks: number,
): Deviation {
  return deviationOf(pathOf(createSimulation(compile(level, accuracy)), holds, maxTicks), reference, maxTicks);
}
