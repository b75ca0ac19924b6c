import type { Hold } from '../../schema/index.ts';
import { finish, type Steps } from '../steps.ts';
import { advanceTo, isSuccess, type Trials } from './trials.ts';

/** Few enough for a step of some ms in a large level. */
const RUNS_A_STEP = 8;

/**
 * Judges many runs at once: sorted by their edges, each goes on from the last state it shares with the one before.
 * A thousand runs that differ by small noise share their first swings, which are then simulated once.
 * @param runs each sorted and disjoint
 * @returns whether each one meets the goal, in the order given
 */
export const judgeAll = (trials: Trials, runs: readonly (readonly Hold[])[]): Uint8Array => finish(judgeInSteps(trials, runs));

/** {@link judgeAll}, some runs a step. */
export function* judgeInSteps(trials: Trials, runs: readonly (readonly Hold[])[]): Steps<Uint8Array> {
  const { simulation, maxTicks } = trials;
  const edges = runs.map((holds) => holds.flat());
  // a run without a next edge waits for the end of time: it sorts behind those that have one
  const edgeOf = (run: number, depth: number): number => Math.min(edges[run][depth] ?? maxTicks, maxTicks);
  const compare = (a: number, b: number): number => {
    const depth = Math.max(edges[a].length, edges[b].length);
    for (let i = 0; i < depth; i++) {
      const difference = edgeOf(a, i) - edgeOf(b, i);
      if (difference !== 0) return difference;
    }
    return a - b;
  };
  const order = [...runs.keys()].sort(compare);

  const succeeded = new Uint8Array(runs.length);
  // states[d]: the state at the d-th edge of the run before, the button not yet moved
  const states: Float64Array[] = [];
  let before = -1;
  // the run before had ended by its edge of this depth: what comes later doesn't matter
  let settled = 0;
  let judged = 0;
  for (const run of order) {
    if (++judged % RUNS_A_STEP === 0) yield null;
    let depth = 0;
    if (before < 0) simulation.reset();
    else {
      while (depth < settled && edgeOf(run, depth) === edgeOf(before, depth)) depth++;
      if (depth === settled) {
        succeeded[run] = succeeded[before];
        continue;
      }
      simulation.restore(states[depth]);
    }
    for (; ; depth++) {
      const tick = edgeOf(run, depth);
      advanceTo(trials, tick, depth % 2 === 1);
      states[depth] = simulation.snapshot(states[depth]);
      if (tick === maxTicks || simulation.ending !== null) break;
    }
    settled = depth;
    succeeded[run] = isSuccess(trials, () => runs[run]) ? 1 : 0;
    before = run;
  }
  return succeeded;
}
