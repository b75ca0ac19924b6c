import type { Scene } from '../engine/index.ts';
import type { Hold } from '../schema/index.ts';
import { cleanRun, createSearch, type Goal, successProbability, verifyRun } from '../solver/index.ts';

const SIGMA = 40;
const ANY: Goal = { minerals: 'any' };

/** Numbers of executions by which a run is judged; the next number is used as long as the run may be the best. */
const RACE = [16, 64, 256];

/** A hold that lasts to the end of a run is prolonged by this many ticks, as `createSolver` does. */
const HOLD_ON = 120;

export interface Restarts {
  /** The best run so far; null before the first. */
  readonly holds: readonly Hold[] | null;
  /** Its share of successes in the executions that it was chosen by. */
  readonly p: number;
  /** Searches for a while; a run that is found is judged. */
  step(): void;
}

/**
 * The obvious method: find one run after the other, each with a new seed, and keep the one that succeeds most often. Nothing is
 * moved.
 */
export function plainRestarts(scene: Scene): Restarts {
  let seed = 0;
  let search = createSearch(scene, { seed });
  let best: { holds: readonly Hold[]; p: number } | null = null;
  return {
    get holds() {
      return best?.holds ?? null;
    },
    get p() {
      return best?.p ?? 0;
    },
    step() {
      search.advance(500);
      const found = search.solutions[0];
      if (found === undefined) return;
      search = createSearch(scene, { seed: ++seed });
      const cleaned = cleanRun(scene, found.holds, ANY);
      for (const holds of [found.holds, cleaned?.run.holds ?? found.holds].map((run) => heldOn(scene, run))) {
        let p = 0;
        for (const samples of RACE) {
          p = successProbability(scene, holds, ANY, SIGMA, { samples, seed: 1 }).p;
          // three standard deviations worse
          if (best !== null && p < best.p - 1.5 / Math.sqrt(samples)) break;
        }
        if (best === null || p > best.p) best = { holds, p };
      }
    },
  };
}

function heldOn(scene: Scene, holds: readonly Hold[]): readonly Hold[] {
  const run = verifyRun(scene, holds, ANY);
  const last = holds[holds.length - 1];
  if (run === null || last === undefined || last[1] <= run.tick) return holds;
  return [...holds.slice(0, -1), [last[0], run.tick + HOLD_ON]];
}
