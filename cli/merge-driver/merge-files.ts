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
