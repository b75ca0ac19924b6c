import { type FileConflict, type LevelFile, SINGLE_KINDS } from '../../schema/index.ts';
import { type Choices, type Conflict, ORDER, partsOfKey } from './conflict.ts';
import { type Merged, SETTINGS } from './merge-levels.ts';
import {
  ALONE,
  fromGroups,
  type Json,
  type Listed,
  listedIn,
  type MergedList,
  OBJECTS,
  RUNS,
  type Together,
  toGroups,
  togetherIn,
} from './merged-lists.ts';

/** The result of a merge as a file: mine stands in place, and `conflicts` lists what is undecided. */
export function withConflicts({ file, conflicts }: Merged): LevelFile {
  if (conflicts.length === 0) return file;
  const fresh = new Set(conflicts.map(({ key }) => key));
  const earlier = (file.conflicts ?? []).filter(({ key }) => !fresh.has(key));
  const now = conflicts.map(({ what, key, base, mine, theirs }) => {
    const values = Object.entries({ base, ours: mine, theirs }).filter(([, value]) => value !== undefined);
    return { what, key, ...Object.fromEntries(values) };
  });
  return { ...file, conflicts: [...earlier, ...now] };
}

type Draft = Record<string, unknown>;

const GROUPS: readonly (readonly MergedList[])[] = [OBJECTS, [RUNS]];

const isObject = (value: unknown): value is Json => typeof value === 'object' && value !== null && !Array.isArray(value);

/** A copy of an object with another value of a field, or of a group of fields. */
function withField(object: Json, field: string, value: unknown, together: Together): Json {
  const groups = toGroups(object, together);
  if (value === undefined) groups.delete(field);
  else groups.set(field, value);
  return fromGroups(groups, together);
}

const entriesIn = (file: Draft, list: string): readonly Json[] => (file[list] ?? []) as readonly Json[];

/** Puts an entry where the one of that name is, or at the end of its list; undefined removes it. */
function putEntry(file: Draft, group: readonly MergedList[], name: string, value: Listed | undefined): void {
  for (const { list, nameKey } of group) {
    const old = entriesIn(file, list);
    const index = old.findIndex((entry) => entry[nameKey] === name);
    const isHere = value?.list === list;
    if (index < 0 && !isHere) continue;
    const put = isHere ? [value.entry] : [];
    file[list] = index < 0 ? [...old, ...put] : [...old.slice(0, index), ...put, ...old.slice(index + 1)];
  }
}

/** Puts their value of a conflict into a file. What is no longer there is left alone. */
function take(file: Draft, { key, theirs }: FileConflict): void {
  const [first, second, third] = partsOfKey(key);
  const one = (list: string) => [...OBJECTS, RUNS].find((other) => other.list === list);
  const list = one(first === ORDER && second !== undefined ? second : first);
  if (list === undefined) {
    if (second === undefined) {
      if (theirs === undefined) delete file[key];
      else file[first] = theirs;
      return;
    }
    const single = SINGLE_KINDS.find((kind) => kind === first);
    const now = file[first];
    if (single === undefined ? !SETTINGS.includes(first) || (now !== undefined && !isObject(now)) : !isObject(now)) return;
    const changed = withField((now ?? {}) as Json, second, theirs, single === undefined ? ALONE : togetherIn(single));
    if (single === undefined && Object.keys(changed).length === 0) delete file[first];
    else file[first] = changed;
    return;
  }
  const { nameKey } = list;
  const group = GROUPS.find((lists) => lists.includes(list)) as readonly MergedList[];
  if (first === ORDER) {
    if (Array.isArray(theirs)) file[list.list] = inOrder(entriesIn(file, list.list), nameKey, theirs);
  } else if (second === undefined) {
    const elsewhere = new Set(
      group.filter((other) => other !== list).flatMap((other) => entriesIn(file, other.list).map((entry) => entry[nameKey])),
    );
    if (Array.isArray(theirs)) file[first] = theirs.filter((entry) => !elsewhere.has(entry[nameKey]));
  } else if (third === undefined) {
    putEntry(file, group, second, listedIn(first, theirs));
  } else {
    const old = group
      .map((other) => ({ other, entry: entriesIn(file, other.list).find((entry) => entry[nameKey] === second) }))
      .find(({ entry }) => entry !== undefined);
    if (old?.entry === undefined) return;
    const entry = withField(old.entry, third, theirs, old.other.together);
    putEntry(file, group, second, { list: old.other.list, entry });
  }
}

/** Entries in the order of their names; those that are not named stay where they are. */
function inOrder(entries: readonly Json[], nameKey: string, names: readonly unknown[]): Json[] {
  const byName = new Map(entries.map((entry) => [entry[nameKey], entry]));
  const sorted = names.flatMap((name): readonly Json[] => {
    const entry = byName.get(name);
    return entry === undefined ? [] : [entry];
  });
  const moved = new Set(sorted);
  let next = 0;
  return entries.map((entry) => (moved.has(entry) ? sorted[next++] : entry));
}

/**
 * Decides conflicts that a merge has left in a file: puts the chosen values in place and removes their entries. Conflicts
 * without a choice stay. Our values are in place already.
 * @returns the file, which is a valid level if the chosen values are valid where they go
 */
export function resolveConflicts(file: LevelFile, choices: Choices): LevelFile {
  const resolved: Draft = { ...file };
  const left: FileConflict[] = [];
  for (const conflict of file.conflicts ?? []) {
    const side = choices.get(conflict.key);
    if (side === undefined) left.push(conflict);
    else if (side === 'theirs') take(resolved, conflict);
  }
  if (left.length > 0) resolved.conflicts = left;
  else delete resolved.conflicts;
  return resolved as LevelFile;
}

/** The conflicts that a merge has left in a file, as conflicts of a merge: ours is mine. */
export const conflictsOf = (file: LevelFile): Conflict[] =>
  (file.conflicts ?? []).map(({ key, what, base, ours, theirs }) => ({ key, what, base, mine: ours, theirs }));
