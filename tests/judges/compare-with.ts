import { type Accuracy, compile, createSimulation } from '../../engine/index.ts';
import { type Deviation, deviationOf, pathOf, type Reference } from '../../engine/work-precision/index.ts';
import type { Hold, Level } from '../../schema/index.ts';

/** Plays holds at one setting and compares the run with the reference. @param maxTicks after which it is a timeout */
export function compareWith(
  reference: Reference,
  level: Level,
  holds: readonly Hold[],
  accuracy: Accuracy,
  maxTicks: number,
): Deviation {
  return deviationOf(pathOf(createSimulation(compile(level, accuracy)), holds, maxTicks), reference, maxTicks);
}
