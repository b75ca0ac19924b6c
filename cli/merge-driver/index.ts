import { playRuns } from '../../check/index.ts';
import { bodyInWords } from '../../check/words/index.ts';
import { compile, type Run, type Terms, WorkBudget } from '../../engine/index.ts';
import { type Conflict, mergeLevels, shareIds, withConflicts } from '../../review/index.ts';
import {
  formatLevel,
  type Level,
  type LevelFile,
  type OwnRules,
  type Problem,
  readLevel,
  resolveLevel,
} from '../../schema/index.ts';
import { readContent } from '../../schema/level/index.ts';
import { tryGit } from '../io/index.ts';

/** The outcome of merging two versions of a level file. */
export type MergedFile =
  /** Only one side changed the file: its bytes stand. */
  | { readonly kind: 'one side'; readonly bytes: Uint8Array }
  | { readonly kind: 'clean'; readonly text: string; readonly ours: Level; readonly theirs: Level; readonly merged: Level }
  /** The file holds our values, and lists the conflicts. */
  | { readonly kind: 'conflicts'; readonly text: string; readonly conflicts: readonly Conflict[] }
  /** A version is no valid level. */
  | { readonly kind: 'no level'; readonly why: string };

/** A version of a level file; its base may be empty. */
type Version = { readonly ok: true; readonly file: LevelFile } | { readonly ok: false; readonly why: string };

const why = (name: string, { line, column, message }: Problem): string =>
  `${name} version is not a valid level: ${line === null ? '' : `${line}:${column} `}${message}`;

function read(name: string, bytes: Uint8Array): Version {
  const reading = readContent(bytes);
  return reading.ok ? { ok: true, file: reading.document.file } : { ok: false, why: why(name, reading.problems[0]) };
}

const isEqual = (a: Uint8Array, b: Uint8Array): boolean => Buffer.compare(a, b) === 0;

/**
 * Merges two versions of a level file. Where only one side changed it, its bytes stand; otherwise the result is in the canonical
 * layout, and every object has an id.
 * @param base the version that both started from; empty: both added the file
 * @param rules the rules of the folder
 */
export function mergeFiles(base: Uint8Array, ours: Uint8Array, theirs: Uint8Array, rules: OwnRules): MergedFile {
  if (isEqual(ours, theirs) || isEqual(base, theirs)) return { kind: 'one side', bytes: ours };
  if (isEqual(base, ours)) return { kind: 'one side', bytes: theirs };
  const old = base.length === 0 ? null : read('the base', base);
  const [here, there] = [read('our', ours), read('their', theirs)];
  for (const version of [here, there, old]) if (version?.ok === false) return { kind: 'no level', why: version.why };
  if (!here.ok || !there.ok || old?.ok === false) throw new Error('unreachable');
  const versions = shareIds(old === null ? null : old.file, here.file, there.file);
  const merged = mergeLevels(versions.base, versions.mine, versions.theirs);
  const file = withConflicts(merged);
  const text = formatLevel(file);
  const reading = readLevel(text);
  if (!reading.ok) return { kind: 'no level', why: why('the merged', reading.problems[0]) };
  if ((file.conflicts ?? []).length > 0) return { kind: 'conflicts', text, conflicts: merged.conflicts };
  const [o, t, m] = [versions.mine, versions.theirs, merged.file].map((one) => resolveLevel(one, rules));
  return { kind: 'clean', text, ours: o, theirs: t, merged: m };
}

/** What a merge did to the runs of a level. */
interface ProofAgain {
  /** For each run that completed the level before the merge and does not any more: what happens now. */
  readonly broken: readonly string[];
  /** Whether a run completed the level on both sides, and none does after the merge. */
  readonly isUnproved: boolean;
}

type Played = ReadonlyMap<string, Run>;

function play(level: Level, terms: Terms): Played {
  const runs = playRuns(compile(level, terms), new WorkBudget(terms.maxWork));
  return new Map(level.runs.map(({ name }, i) => [name, runs[i]]));
}

const completes = (run: Run | undefined): boolean => run?.outcome === 'completed' && run.stopped === null;

function endInWords({ outcome, with: touched, tick, time, stopped }: Run): string {
  if (stopped !== null) return 'costs more work than a check allows';
  switch (outcome) {
    case 'completed':
      return `completes it at tick ${tick}`;
    case 'collided':
      return `dies at tick ${tick}${touched === null ? '' : `, at ${bodyInWords(touched)}`}`;
    case 'lost':
      return `is lost at tick ${tick}`;
    case 'timeout':
      return `is not over after ${Number(time.toFixed(3))} s`;
  }
}

function beforeInWords(here: Run | undefined, there: Run | undefined): string {
  if (here !== undefined && there !== undefined)
    return here.tick === there.tick
      ? `completed at tick ${here.tick} on both sides`
      : `completed at tick ${here.tick} on our side and ${there.tick} on theirs`;
  return here === undefined ? `completed at tick ${there?.tick} on their side` : `completed at tick ${here.tick} on our side`;
}

/** Plays the runs of a merged level under some terms, and compares how they end with how they ended on both sides. */
export function playAgain(ours: Level, theirs: Level, merged: Level, terms: Terms): ProofAgain {
  const [here, there, now] = [ours, theirs, merged].map((level) => play(level, terms));
  const broken: string[] = [];
  for (const [name, run] of now) {
    const before = [here.get(name), there.get(name)];
    const known = before.filter((one) => one !== undefined);
    if (completes(run) || known.length === 0 || !known.every(completes)) continue;
    broken.push(`the run ${JSON.stringify(name)} now ${endInWords(run)} (before: ${beforeInWords(before[0], before[1])})`);
  }
  const some = (played: Played) => [...played.values()].some(completes);
  const isUnproved = some(here) && some(there) && !some(now);
  return { broken, isUnproved };
}

/** The outcome of merging files line by line. */
type TextMerge = 'clean' | 'conflicts' | 'not merged';

/**
 * Merges text files line by line, as git does on its own, with marks around conflicts.
 * @param into our version, which becomes the result; it is left alone if the files are not text
 */
export function mergeText(base: string, into: string, theirs: string, markerSize: number): TextMerge {
  const labels = ['ours', 'base', 'theirs'].flatMap((label) => ['-L', label]);
  const args = ['merge-file', '-q', `--marker-size=${markerSize}`, ...labels, into, base, theirs];
  const answer = tryGit(args, { folder: '.' });
  const status = answer instanceof Error ? null : answer.status;
  if (status === 0) return 'clean';
  return status !== null && status > 0 && status < 128 ? 'conflicts' : 'not merged';
}
