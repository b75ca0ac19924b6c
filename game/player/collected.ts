import type { RunEvent, Simulation } from '../../engine/index.ts';

/**
 * The number of different minerals that she has collected. `mineralCount` counts what the original game counts: of several
 * minerals touched in one frame all, and the next frame those again that it has not removed.
 * @param events what has happened since the start
 * @param count minerals in the level
 */
export function countCollected(simulation: Pick<Simulation, 'isCollected'>, events: readonly RunEvent[], count: number): number {
  const collected = new Set<number>();
  for (const event of events) if (event.type === 'mineral') collected.add(event.index);
  // one that she touches at the start may come without an event
  for (let i = 0; i < count; i++) if (simulation.isCollected(i)) collected.add(i);
  return collected.size;
}
