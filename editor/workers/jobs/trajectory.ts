import { countMinerals } from '../../../check/words/index.ts';
import { compile, DEFAULT_MAX_TIME, joinHolds, simulate, TICK_RATE } from '../../../engine/index.ts';
import type { Start } from '../work.ts';
import { follow } from './follow.ts';

const MAX_TICKS = Math.round(DEFAULT_MAX_TIME * TICK_RATE);

/** Follows her tick by tick, and sums the run up. */
export const trajectory: Start<'trajectory'> = function* ({ level, accuracy, holds }) {
  const scene = compile(level, accuracy);
  const { points, turns } = yield* follow(scene, holds, MAX_TICKS);
  const run = simulate(scene, joinHolds(holds));
  const { outcome, with: touched, time, tick } = run;
  return {
    points,
    turns,
    end: { outcome, with: touched, time, tick },
    minerals: countMinerals(run),
    clearance: run.clearance?.distance ?? null,
  };
};
