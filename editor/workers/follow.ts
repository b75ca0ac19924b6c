import { createSimulation, joinHolds, playScript, type Scene, STATE_SIZE } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';

/** ticks per step */
const TICKS = 20;

/** Her way, an entry for every tick and one for the end. */
export interface Followed {
  /** x, y in px */
  readonly points: Float32Array;
  /** The direction of the box's x axis: cos, sin. */
  readonly turns: Float32Array;
}

/** Follows her tick by tick, in steps. @param until the last tick */
export function* follow(scene: Scene, holds: readonly Hold[], until: number): Generator<null, Followed, void> {
  const simulation = createSimulation(scene);
  const script = joinHolds(holds);
  const state = new Float64Array(STATE_SIZE);
  const points: number[] = [];
  const turns: number[] = [];
  for (;;) {
    simulation.readState(state);
    points.push(state[0], state[1]);
    turns.push(state[4], state[5]);
    const { tick } = simulation;
    if (simulation.ending !== null || tick >= until) break;
    playScript(simulation, script, tick + 1);
    if (tick % TICKS === 0) yield null;
  }
  return { points: Float32Array.from(points), turns: Float32Array.from(turns) };
}
