import { termsReport } from '../../check/words/index.ts';
import type { Terms } from '../../engine/index.ts';
import {
  assessLevel,
  type Change,
  changesInWords,
  diffLevels,
  effectsInWords,
  playAlike,
  renamedStanding,
  standingInWords,
} from '../../review/index.ts';
import { conflictProblems, isSame, type LevelReading, readLevel } from '../../schema/index.ts';
import { nameOfFile } from '../io/index.ts';
import { showProblems } from '../report-parts/index.ts';
import type { DiffedLevel, DiffStatus, DiffTask, FileVersion, JudgedVersion } from './comparison.ts';

type ValidReading = Extract<LevelReading, { readonly ok: true }>;

interface Version {
  readonly file: FileVersion;
  readonly read: LevelReading;
  readonly terms: Terms;
}

/** Compares two versions of a level file and judges both. */
export function diffLevel({ pair, settings: { terms, slack } }: DiffTask): DiffedLevel {
  const open = (file: FileVersion | null, own: Terms): Version | null =>
    file === null ? null : { file, read: readLevel(file.bytes, { rules: own.rules }), terms: own };
  const [before, after] = [open(pair.before, terms.before), open(pair.after, terms.after)];
  const [old, now] = [validOf(before), validOf(after)];
  const changes = old === null || now === null ? null : diffLevels(old.document.file, now.document.file);
  const judged = judgeBoth(before, after, slack);
  const status = statusOf(pair.before, pair.after, changes);
  return {
    status,
    ...judged,
    changes,
    words: changes === null || now === null ? [] : changesInWords(changes, now.document.file),
    effects: effectsOf(judged.before, judged.after, (now ?? old)?.level.range ?? 0),
  };
}

const validOf = (version: Version | null): ValidReading | null => (version?.read.ok === true ? version.read : null);

function statusOf(before: FileVersion | null, after: FileVersion | null, changes: readonly Change[] | null): DiffStatus {
  if (before === null) return 'added';
  if (after === null) return 'removed';
  if (Buffer.compare(before.bytes, after.bytes) === 0) return before.path === after.path ? 'rules' : 'renamed';
  return changes !== null && changes.length === 0 ? 'layout' : 'changed';
}

/** Judges both versions; only once if they play alike. */
function judgeBoth(
  before: Version | null,
  after: Version | null,
  slack: boolean,
): { readonly before: JudgedVersion | null; readonly after: JudgedVersion | null } {
  const [old, now] = [validOf(before), validOf(after)];
  const first = before === null ? null : judge(before, slack);
  if (after === null) return { before: first, after: null };
  if (
    first === null ||
    first.standing === null ||
    old === null ||
    now === null ||
    isUndecided(now) ||
    !isUnderSame(before, after) ||
    !playAlike(old.level, now.level)
  ) {
    return { before: first, after: judge(after, slack) };
  }
  const standing = renamedStanding(first.standing, old.level, now.level);
  return { before: first, after: { ...first, file: after.file.path, name: now.level.name, standing } };
}

/** Whether both are judged at one accuracy and within the same limits; rules are compared with the levels. */
const isUnderSame = (before: Version | null, { terms: now }: Version): boolean =>
  before !== null &&
  isSame(before.terms.accuracy, now.accuracy) &&
  before.terms.maxTime === now.maxTime &&
  before.terms.maxWork === now.maxWork;

/** Whether a merge left conflicts in it. */
const isUndecided = ({ document }: ValidReading): boolean => (document.file.conflicts ?? []).length > 0;

function judge({ file: { path: file }, read, terms }: Version, slack: boolean): JudgedVersion {
  const under = termsReport({ terms, level: read.ok ? read.level : terms });
  if (!read.ok) {
    return {
      file,
      name: nameOfFile(file),
      terms: under,
      verdict: 'invalid',
      problems: showProblems(read.problems, read.text),
      standing: null,
    };
  }
  const undecided = conflictProblems(read.document.file, read.document.locate);
  if (undecided.length > 0) {
    return {
      file,
      name: read.level.name,
      terms: under,
      verdict: 'invalid',
      problems: showProblems(undecided, read.document.text),
      standing: null,
    };
  }
  const standing = assessLevel(read.level, { terms, slack });
  return { file, name: read.level.name, terms: under, verdict: standing.verdict, problems: [], standing };
}

function effectsOf(before: JudgedVersion | null, after: JudgedVersion | null, range: number): string[] {
  if (before === null || after === null) {
    const standing = (before ?? after)?.standing ?? null;
    return [standing === null ? 'not a valid level' : standingInWords(standing, range)];
  }
  if (before.standing !== null && after.standing !== null) return effectsInWords(before.standing, after.standing, range);
  if (before.verdict === after.verdict) return ['not a valid level, before and after'];
  return [`${before.verdict} -> ${after.standing === null ? after.verdict : standingInWords(after.standing, range)}`];
}
