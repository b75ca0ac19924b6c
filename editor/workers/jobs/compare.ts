import { compile, type Run, simulate, type Terms, WorkBudget } from '../../../engine/index.ts';
import { renderComparison } from '../../../picture/comparison/index.ts';
import {
  assessLevel,
  diffLevels,
  effectsInWords,
  marksOf,
  playAlike,
  renamedStanding,
  standingInWords,
  type VersionStanding,
} from '../../../review/index.ts';
import { type Level, type LevelFile, readLevel } from '../../../schema/index.ts';
import { job, type Work } from '../job.ts';

/** Two versions of a level, compared. */
export interface Compared {
  /** null: a version can't be drawn. */
  readonly svg: string | null;
  /** What is true of each, in words. */
  readonly before: string;
  readonly after: string;
  /** What follows from the changes, in words. */
  readonly effects: readonly string[];
}

/** Two versions of a level file in one picture, and what is true of both. */
export const compare = job<
  {
    readonly before: string;
    readonly after: string;
    readonly terms: Terms;
    readonly width: number;
    readonly theme: 'dark' | 'light';
  },
  Compared
>({ name: 'compare', lane: 'long', most: 60_000 });

/** A version as it is played. */
interface Version {
  readonly file: LevelFile;
  readonly level: Level;
}

function readVersion(text: string, { rules }: Terms): Version | null {
  const reading = readLevel(text, { rules });
  return reading.ok ? { file: reading.document.file, level: reading.level } : null;
}

/** Whether a merge left conflicts in it. */
const isUndecided = ({ file }: Version): boolean => (file.conflicts ?? []).length > 0;

const standingOf = (version: Version, terms: Terms): VersionStanding | null =>
  isUndecided(version) ? null : assessLevel(version.level, { terms, slack: true });

const inWords = (standing: VersionStanding | null, { level }: Version): string =>
  standing === null ? 'not judged: a merge has left conflicts in it' : standingInWords(standing, level.range);

/** The run by which a version is judged; null if it takes too much work. */
function runOf(standing: VersionStanding | null, { level }: Version, terms: Terms): Run | null {
  if (standing?.run == null) return null;
  const run = simulate(compile(level, terms), standing.run.holds, { budget: new WorkBudget(terms.maxWork) });
  return run.stopped === null ? run : null;
}

/** Compares two versions of a level as `gq diff` does. */
export const compareWork: Work<typeof compare> = {
  of: compare,
  *steps({ before, after, terms, width, theme }) {
    const [old, now] = [readVersion(before, terms), readVersion(after, terms)];
    if (old === null || now === null) {
      const word = (version: Version | null) => (version === null ? 'not a valid level' : 'a valid level');
      return { svg: null, before: word(old), after: word(now), effects: [] };
    }
    const was = standingOf(old, terms);
    yield null;
    const isAlike = was !== null && !isUndecided(now) && playAlike(old.level, now.level);
    const is = isAlike ? renamedStanding(was, old.level, now.level) : standingOf(now, terms);
    yield null;
    const runs = [
      { run: runOf(was, old, terms), label: 'before' },
      { run: runOf(is, now, terms), label: 'after' },
    ].flatMap(({ run, label }) => (run === null ? [] : [{ run, label }]));
    const marks = marksOf(diffLevels(old.file, now.file), old.level, now.level);
    const { svg } = renderComparison(old.level, now.level, marks, { runs, width, theme, title: now.level.name });
    return {
      svg,
      before: inWords(was, old),
      after: inWords(is, now),
      effects: was === null || is === null ? [] : effectsInWords(was, is, now.level.range),
    };
  },
};
