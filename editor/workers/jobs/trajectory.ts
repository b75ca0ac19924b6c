import { countMinerals } from '../../../check/words/index.ts';
import { compile, joinHolds, maxTicksOf, simulate } from '../../../engine/index.ts';
import type { Start } from '../work.ts';
import { follow } from './follow.ts';

/** Follows her tick by tick, and sums the run up. */
export const trajectory: Start<'trajectory'> = function* ({ level, terms, holds }) {
  const scene = compile(level, terms);
  const { points, turns } = yield* follow(scene, holds, maxTicksOf(terms));
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
