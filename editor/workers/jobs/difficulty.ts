import { compile } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { createSolver, type Difficulty, type Goal, measureDifficulty } from '../../../solver/index.ts';
import { job, type Played, type Work } from '../job.ts';
import { type Solving, search } from './solve.ts';

/** How hard the level is, measured with the best run found within the budget (ms) if none is given. null: no run was found to measure. */
export const difficulty = job<
  Played & { readonly holds: readonly Hold[] | null; readonly goal: Goal; readonly budget: number },
  Difficulty | null,
  Solving
>({ name: 'difficulty', lane: 'long', most: null });

/** effort in ticks for the secondary searches: a run with all minerals, and one without each asteroid */
const EFFORT = 400_000;
const ASTEROID_EFFORT = 100_000;

/** Measures how hard a level is; searches for a run first if none is given. */
export const difficultyWork: Work<typeof difficulty> = {
  of: difficulty,
  *steps({ level, terms, holds, goal, budget }, now) {
    const scene = compile(level, terms);
    const known = level.runs.map(({ holds: own }) => own);
    const run = holds ?? (yield* search(createSolver(scene, { goal, known }), budget, now)).solutions[0]?.holds ?? null;
    if (run === null) return null;
    return measureDifficulty(scene, run, { goal, effort: EFFORT, asteroidEffort: ASTEROID_EFFORT });
  },
};
