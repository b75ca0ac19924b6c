import type { Hold } from '../../../schema/basics/index.ts';
import { finish, type Steps } from '../../steps.ts';
import { advanceTo, isSuccess, type Trials } from './trials.ts';

/** So few that one step takes a few milliseconds in a large level. */
const RUNS_A_STEP = 8;

/**
 * Judges many runs at once. Sorted by their edges, each run continues from the last state that it shares with the one before: a
 * thousand runs that differ by a little noise share their first swings, which are then simulated once.
 * @param runs each sorted and disjoint
 * @returns 1 for each run that meets the goal, else 0, in the order given
 */
export const judgeAll = (trials: Trials, runs: readonly (readonly Hold[])[]): Uint8Array => finish(judgeInSteps(trials, runs));

/** {@link judgeAll}, a few runs per step. */
export function* judgeInSteps(trials: Trials, runs: readonly (readonly Hold[])[]): Steps<Uint8Array> {
  const { simulation, maxTicks } = trials;
  const edges = runs.map((holds) => holds.flat());
  // A run without a next edge sorts behind those that have one.
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
  // states[d]: the state at edge d of the previous run, before the button changes.
  const states: Float64Array[] = [];
  let before = -1;
  // The previous run had ended by its edge of this depth, so its later edges do not matter.
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
