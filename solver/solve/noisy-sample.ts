import type { Hold } from '../../schema/basics/index.ts';
import { judgeAll, mirroredShift, shiftHolds, type TickNoise, type Trials } from '../robustness/index.ts';

/** What timing noise did to a run. */
export interface NoisySample {
  /** Attempts that met the goal. */
  readonly successes: number;
  /** Attempts simulated. */
  readonly tried: number;
  /**
   * The mean shift of each edge over the successful attempts, ticks; it points to where there is more room. All 0 without a
   * success.
   */
  readonly drift: Float64Array;
}

/**
 * Simulates a run under timing noise, with attempts to choose by.
 * @param from the first attempt of the seed's endless sequence
 * @param to one past the last attempt
 */
export function sampleNoise(
  trials: Trials,
  holds: readonly Hold[],
  noise: TickNoise,
  seed: number,
  from: number,
  to: number,
): NoisySample {
  const edges = 2 * holds.length;
  const shifts: Int32Array[] = [];
  for (let i = from; i < to; i++) {
    const shift = new Int32Array(edges);
    for (let edge = 0; edge < edges; edge++) shift[edge] = mirroredShift(noise, seed, i, edge);
    shifts.push(shift);
  }
  const succeeded = judgeAll(
    trials,
    shifts.map((shift) => shiftHolds(holds, shift)),
  );
  const drift = new Float64Array(edges);
  let successes = 0;
  for (let i = 0; i < shifts.length; i++) {
    if (succeeded[i] === 0) continue;
    successes++;
    for (let edge = 0; edge < edges; edge++) drift[edge] += shifts[i][edge];
  }
  if (successes > 0) for (let edge = 0; edge < edges; edge++) drift[edge] /= successes;
  return { successes, tried: shifts.length, drift };
}
