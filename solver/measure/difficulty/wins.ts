import type { Simulation } from '../../../engine/index.ts';

/** Whether a simulation has ended in the black hole with at least `needed` different minerals. */
export function wins(simulation: Simulation, needed: number): boolean {
  if (simulation.ending?.outcome !== 'completed') return false;
  if (needed === 0) return true;
  let collected = 0;
  for (let i = 0; i < simulation.scene.minerals.count; i++) if (simulation.isCollected(i)) collected++;
  return collected >= needed;
}
