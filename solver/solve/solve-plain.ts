import type { Hold } from '../../schema/index.ts';
import { createRandom } from '../random.ts';
import { changeRun } from './change-run.ts';
import { type Desk, playable } from './desk.ts';
import { compareSolutions, mergeSolutions } from './merge-solutions.ts';
import type { Solution } from './solution.ts';

/** Changes tried on a run before the next is sought. */
const CHANGES = 60;

/** Runs with the fewest presses, the shortest time, or whichever come first; those that are known come before all. Yields between small pieces of work. */
export function* solvePlain(desk: Desk): Generator<void, void> {
  const { restarts, objective, count } = desk;
  const random = createRandom(desk.seedOf(0));
  const known = [...desk.known];
  while (known.length > 0 || !restarts.exhausted) {
    const given = known.shift();
    const run = given === undefined ? restarts.next() : (playable(desk, given)?.candidate ?? null);
    yield;
    if (run === null) continue;
    let best = toSolution(desk, run);
    desk.solutions = mergeSolutions([desk.solutions, [best]], { count });
    if (objective !== 'first') {
      for (let i = 0; i < CHANGES && best.holds.length > 0; i++) {
        const changed = tried(desk, changeRun(best.holds, random));
        if (changed !== null && compareSolutions(changed, best) < 0) best = changed;
        yield;
      }
      desk.solutions = mergeSolutions([desk.solutions, [best]], { count });
    }
    if (isFinal(desk)) return;
  }
}

function tried(desk: Desk, holds: readonly Hold[]): Solution | null {
  const run = playable(desk, holds);
  return run === null ? null : toSolution(desk, run.candidate);
}

function toSolution({ objective }: Desk, candidate: Omit<Solution, 'score' | 'p40' | 'certified'>): Solution {
  const score = objective === 'time' ? -candidate.time : objective === 'presses' ? -candidate.holds.length : 0;
  return { ...candidate, score, p40: null, certified: false };
}

/** Whether nothing can get better: enough of whatever came first; a run without a press. */
function isFinal({ objective, solutions, count }: Desk): boolean {
  if (objective === 'first') return solutions.length >= count;
  return objective === 'presses' && count === 1 && solutions.length === 1 && solutions[0].holds.length === 0;
}
