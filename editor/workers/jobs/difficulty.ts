import { compile } from '../../../engine/index.ts';
import { createSolver, measureDifficulty } from '../../../solver/index.ts';
import type { Start } from '../work.ts';
import { search } from './solve.ts';

/** effort in ticks for the secondary searches: a run with all minerals, and one without each asteroid */
const EFFORT = 400_000;
const ASTEROID_EFFORT = 100_000;

/** Measures how hard a level is; searches for a run first if none is given. */
export const difficulty: Start<'difficulty'> = function* ({ level, terms, holds, goal, budget }, now) {
  const scene = compile(level, terms);
  const known = level.runs.map(({ holds: own }) => own);
  const run = holds ?? (yield* search(createSolver(scene, { goal, known }), budget, now)).solutions[0]?.holds ?? null;
  if (run === null) return null;
  return measureDifficulty(scene, run, { goal, effort: EFFORT, asteroidEffort: ASTEROID_EFFORT });
};
