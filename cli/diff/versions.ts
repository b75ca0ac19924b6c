import { compile, type Run, simulate, type Terms, WorkBudget } from '../../engine/index.ts';
import type { Mark } from '../../picture/comparison/index.ts';
import { marksOf, type StandingRun } from '../../review/index.ts';
import { type Level, readLevel } from '../../schema/index.ts';
import type { DiffedLevel, DiffSettings, FileVersion, JudgedVersion, Pair } from './comparison.ts';

/** A version of a level with the run by which it is judged, for a picture. */
export interface PlayedVersion {
  readonly level: Level;
  readonly run: Run | null;
  readonly judged: StandingRun | null;
}

/** Both versions of a level for a picture; null where there is no valid level. */
export interface PlayedVersions {
  readonly before: PlayedVersion | null;
  readonly after: PlayedVersion | null;
  readonly marks: readonly Mark[];
}

/** Reads both versions again and plays their runs. */
export function playVersions(pair: Pair, diffed: DiffedLevel, { terms }: DiffSettings): PlayedVersions {
  const before = play(pair.before, diffed.before, terms.before);
  const after = play(pair.after, diffed.after, terms.after);
  const marks = before === null || after === null ? [] : marksOf(diffed.changes ?? [], before.level, after.level);
  return { before, after, marks };
}

function play(file: FileVersion | null, judged: JudgedVersion | null, terms: Terms): PlayedVersion | null {
  if (file === null || judged?.standing == null) return null;
  const read = readLevel(file.bytes, { rules: terms.rules });
  if (!read.ok) return null;
  const { run } = judged.standing;
  if (run === null) return { level: read.level, run: null, judged: null };
  const played = simulate(compile(read.level, terms), run.holds, { budget: new WorkBudget(terms.maxWork) });
  return { level: read.level, run: played.stopped === null ? played : null, judged: run };
}
