import type { Hold } from '../../schema/basics/index.ts';
import { createRandom } from '../random.ts';
import { changeRun } from './change-run.ts';
import { compareSolutions, mergeSolutions } from './merge-solutions.ts';
import type { Solution } from './solution.ts';
import { playable, type SolverSession } from './solver-session.ts';

/** Variations tried on a run before the next one is sought. */
const CHANGES = 60;

/**
 * Solves for the objectives `presses`, `time` and `first`, beginning with the known runs. Yields between small pieces of work.
 */
export function* solvePlain(session: SolverSession): Generator<void, void> {
  const { restarts, objective, count } = session;
  const random = createRandom(session.seedOf(0));
  const known = [...session.known];
  while (known.length > 0 || !restarts.exhausted) {
    const given = known.shift();
    const run = given === undefined ? restarts.next() : (playable(session, given)?.verified ?? null);
    yield;
    if (run === null) continue;
    let best = toSolution(session, run);
    session.solutions = mergeSolutions([session.solutions, [best]], { count });
    if (objective !== 'first') {
      for (let i = 0; i < CHANGES && best.holds.length > 0; i++) {
        const changed = tried(session, changeRun(best.holds, random));
        if (changed !== null && compareSolutions(changed, best) < 0) best = changed;
        yield;
      }
      session.solutions = mergeSolutions([session.solutions, [best]], { count });
    }
    if (isFinal(session)) return;
  }
}

function tried(session: SolverSession, holds: readonly Hold[]): Solution | null {
  const run = playable(session, holds);
  return run === null ? null : toSolution(session, run.verified);
}

function toSolution({ objective }: SolverSession, candidate: Omit<Solution, 'score' | 'p40' | 'certified'>): Solution {
  const score = objective === 'time' ? -candidate.time : objective === 'presses' ? -candidate.holds.length : 0;
  return { ...candidate, score, p40: null, certified: false };
}

/** Whether nothing can get better: there are enough runs under `first`, or a run without a press under `presses`. */
function isFinal({ objective, solutions, count }: SolverSession): boolean {
  if (objective === 'first') return solutions.length >= count;
  return objective === 'presses' && count === 1 && solutions.length === 1 && solutions[0].holds.length === 0;
}
