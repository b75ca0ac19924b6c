import { createSimulation, joinHolds, maxTicksOf, type Scene, STATE_SIZE } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';

/**
 * The path of some holds: x, y in px at every tick and at the end.
 * @param until the last tick
 */
export function wayOf(scene: Scene, holds: readonly Hold[], until: number = maxTicksOf(scene.terms)): Float32Array {
  const simulation = createSimulation(scene);
  const script = joinHolds(holds);
  const state = new Float64Array(STATE_SIZE);
  const points: number[] = [];
  const see = () => {
    simulation.readState(state);
    points.push(state[0], state[1]);
  };
  see();
  let next = 0;
  while (simulation.ending === null && simulation.tick < until) {
    const { tick } = simulation;
    while (next < script.length && script[next][1] <= tick) next++;
    simulation.advance(1, next < script.length && script[next][0] <= tick);
    see();
  }
  return Float32Array.from(points);
}

/** A path known at every `ticks` ticks, interpolated linearly to one entry per tick. */
export function everyTick(points: Float32Array, ticks: number): Float32Array {
  const count = points.length / 2;
  if (count < 2) return points;
  const filled = new Float32Array(2 * ((count - 1) * ticks + 1));
  for (let i = 0; i < count - 1; i++) {
    for (let k = 0; k <= ticks; k++) {
      const share = k / ticks;
      const o = 2 * (i * ticks + k);
      filled[o] = points[2 * i] * (1 - share) + points[2 * i + 2] * share;
      filled[o + 1] = points[2 * i + 1] * (1 - share) + points[2 * i + 3] * share;
    }
  }
  return filled;
}
