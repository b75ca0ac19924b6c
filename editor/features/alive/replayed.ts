import { createSimulation, maxTicksOf, playScript, type Scene, WorkBudget, WorkLimitReached } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { MOST_WORK } from '../../core/proof/index.ts';

/** How a run that completes a level does so. */
export interface Completion {
  readonly tick: number;
  /** Indices of the collected minerals. */
  readonly minerals: readonly number[];
}

/**
 * Plays a run from the start, with no more work than a frame has room for.
 * @param holds sorted and disjoint
 * @returns null if it does not complete the level, or takes too much work
 */
export function replayed(scene: Scene, holds: readonly Hold[]): Completion | null {
  try {
    const simulation = createSimulation(scene, new WorkBudget(MOST_WORK));
    playScript(simulation, holds, maxTicksOf(scene.terms));
    const { ending } = simulation;
    if (ending?.outcome !== 'completed') return null;
    const minerals = Array.from({ length: scene.minerals.count }, (_, i) => i).filter((i) => simulation.isCollected(i));
    return { tick: ending.tick, minerals };
  } catch (error) {
    if (error instanceof WorkLimitReached) return null;
    throw error;
  }
}
