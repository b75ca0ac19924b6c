import { compile, createSimulation, joinHolds, playScript, STATE_SIZE } from '../../../engine/index.ts';
import type { Start } from '../work.ts';

/** ticks per step */
const TICKS = 20;

/** Follows her tick by tick. */
export const path: Start<'path'> = function* ({ level, accuracy, holds, until }) {
  const simulation = createSimulation(compile(level, accuracy));
  const script = joinHolds(holds);
  const state = new Float64Array(STATE_SIZE);
  const points: number[] = [];
  for (;;) {
    simulation.readState(state);
    points.push(state[0], state[1]);
    const { tick } = simulation;
    if (simulation.ending !== null || tick >= until) break;
    playScript(simulation, script, tick + 1);
    if (tick % TICKS === 0) yield null;
  }
  return { points: Float32Array.from(points) };
};
