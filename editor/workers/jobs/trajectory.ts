import { countMinerals } from '../../../check/words/index.ts';
import { compile, DEFAULT_MAX_TICKS, joinHolds, simulate } from '../../../engine/index.ts';
import type { Start } from '../work.ts';
import { follow } from './follow.ts';

/** Follows her tick by tick, and sums the run up. */
export const trajectory: Start<'trajectory'> = function* ({ level, accuracy, holds }) {
  const scene = compile(level, accuracy);
  const { points, turns } = yield* follow(scene, holds, DEFAULT_MAX_TICKS);
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
