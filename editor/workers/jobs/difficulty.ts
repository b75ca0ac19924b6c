import { compile, type Terms } from '../../../engine/index.ts';
import { type Hold, readLevel } from '../../../schema/index.ts';
import { createSolver, type Difficulty, type Goal, type Grade, measureDifficulty } from '../../../solver/index.ts';
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

/** The grade of a level file by its own runs, as `gq difficulty` measures one of many levels, but without a search. null: none of them completes it. */
export const grade = job<{ readonly text: string; readonly terms: Terms }, Grade | null>({
  name: 'grade',
  lane: 'long',
  most: 120_000,
});

/** Every how many ticks a single press is tried, as `gq difficulty` does for one of many levels. */
const ONE_PRESS_STRIDE = 4;

/** Grades a level file by its own runs. What costs much and does not change the grade is left out. */
export const gradeWork: Work<typeof grade> = {
  of: grade,
  *steps({ text, terms }) {
    const reading = readLevel(text, { rules: terms.rules });
    if (!reading.ok) return null;
    yield null;
    const { level } = reading;
    const runs = level.runs.map(({ holds }) => holds);
    const nothingElse = { effort: 0, asteroidEffort: 0, playerEffort: 0, onePressStride: ONE_PRESS_STRIDE };
    return measureDifficulty(compile(level, terms), null, { runs, ...nothingElse })?.grade ?? null;
  },
};
