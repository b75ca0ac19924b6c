import { type Scene, WorkBudget } from '../engine/index.ts';
import type { Hold } from '../schema/index.ts';
import { certify } from '../solver/index.ts';
import { withinWork } from './within-work.ts';

/** The most runs to simulate for one level: a tenth of what a person who asks for one level gets. */
const MOST_RUNS = 1000;

/** Ticks beyond this are not counted: no player needs more than a sixth of a second. */
export const MOST_TICKS = 10;

/**
 * Measures by how many ticks all presses and releases of a run may move, as a lock records it. The limits count work and not
 * time, so the result is the same on every machine; where they end the measurement, it is a lower bound. It may cost half of the work that the level may.
 * @param scene the compiled level
 * @param holds a run that completes the level
 * @returns the certified ticks, at most 10; null when the work does not suffice
 */
export function ticksToAgree(scene: Scene, holds: readonly Hold[]): number | null {
  const budget = new WorkBudget(scene.terms.maxWork / 2);
  const certified = withinWork(budget, () =>
    certify(scene, holds, { minerals: 'any' }, { limit: MOST_TICKS, maxRuns: MOST_RUNS, budget }),
  );
  return certified?.ticks ?? null;
}
