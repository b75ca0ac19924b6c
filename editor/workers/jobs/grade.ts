import { compile, type Terms } from '../../../engine/index.ts';
import { readLevel } from '../../../schema/index.ts';
import { type Grade, measureDifficulty } from '../../../solver/index.ts';
import { job, type Work } from '../job.ts';

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
