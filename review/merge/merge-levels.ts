import {
  type FileConflict,
  isSame,
  KINDS,
  kindOfList,
  type LevelFile,
  LIMITS,
  notesInOrder,
  type RunNote,
  SINGLE_KINDS,
} from '../../schema/index.ts';
import { fits as fitsShape, shapeOfObject } from '../../schema/level/index.ts';
import { namedNotes } from '../notes.ts';
import { type Choices, type Conflict, conflictKey, ORDER } from './conflict.ts';
import {
  ALONE,
  fromGroups,
  inList,
  type Json,
  keysInOrder,
  type Listed,
  listedIn,
  type MergedList,
  mergeOrder,
  OBJECTS,
  RUNS,
  type Together,
  toGroups,
  togetherIn,
} from './merged-lists.ts';

export interface Merged {
  readonly file: LevelFile;
  /** All conflicts, resolved or not; unresolved ones are mine in `file`. */
  readonly conflicts: readonly Conflict[];
}

/** Keys with an object of settings, each of which is merged by itself. */
export const SETTINGS: readonly string[] = ['rules', 'allow'];

/** The entries of lists, by name. */
type Entries = ReadonlyMap<string, Listed>;

function entriesOf(lists: readonly MergedList[], file: Json): Entries {
  const entries = new Map<string, Listed>();
  for (const { list, nameKey } of lists)
    for (const entry of (file[list] ?? []) as readonly Json[]) entries.set(String(entry[nameKey]), { list, entry });
  return entries;
}

/** Whether an object can belong to a list of another kind. */
const fits = (list: string, entry: Json): boolean => fitsShape(entry, shapeOfObject(kindOfList(list as never)));

class Merge {
  readonly conflicts: Conflict[] = [];

  /** @param doubtful keys of values of the base that are not known: an earlier merge left them undecided */
  constructor(
    private readonly choices: Choices,
    private readonly doubtful: readonly string[],
  ) {}

  /** Merges one value as a whole. */
  value(key: string, what: string, bases: readonly unknown[], mine: unknown, theirs: unknown): unknown {
    if (isSame(mine, theirs)) return mine;
    if (!this.isDoubtful(key)) {
      if (bases.some((base) => isSame(base, theirs))) return mine;
      if (bases.every((base) => isSame(base, mine))) return theirs;
    }
    return this.conflict({ key, what, base: bases[0], mine, theirs });
  }

  fields(key: readonly string[], what: string, together: Together, bases: readonly Json[], mine: Json, theirs: Json): Json {
    const [m, t, ...b] = [mine, theirs, ...bases].map((object) => toGroups(object, together));
    const merged = new Map<string, unknown>();
    for (const field of keysInOrder(b[0].keys(), m.keys(), t.keys())) {
      const old = b.map((groups) => groups.get(field));
      const own = key[0] === RUNS.list && field === 'notes' ? mergeNotes(old, m.get(field), t.get(field)) : null;
      const name = conflictKey(...key, field);
      const isMerged = own !== null && !this.isDoubtful(name);
      const value = isMerged ? own.notes : this.value(name, `${what}, ${field}`, old, m.get(field), t.get(field));
      if (value !== undefined) merged.set(field, value);
    }
    return fromGroups(merged, together);
  }

  /** Merges fields that a file may omit altogether. None and an empty object mean the same, but differ as text. */
  optionalFields(
    key: string,
    bases: readonly (Json | undefined)[],
    mine: Json | undefined,
    theirs: Json | undefined,
  ): Json | undefined {
    const before = bases.map((base) => base ?? {});
    const merged = this.fields([key], key, ALONE, before, mine ?? {}, theirs ?? {});
    if (Object.keys(merged).length > 0) return merged;
    const sides = isSame(bases[0], mine) ? [theirs] : isSame(bases[0], theirs) ? [mine] : [mine, theirs];
    return sides.some((side) => side !== undefined && Object.keys(side).length === 0) ? merged : undefined;
  }

  /** Merges lists whose entries have names: objects by id, runs by name. @returns the lists that the result has */
  lists(lists: readonly MergedList[], bases: readonly Json[], mine: Json, theirs: Json): Map<string, readonly Json[]> {
    const byList = new Map(lists.map((one) => [one.list, one]));
    const [m, t, ...b] = [mine, theirs, ...bases].map((file) => entriesOf(lists, file));
    const merged = new Map<string, Listed>();
    for (const name of new Set([...m.keys(), ...t.keys()])) {
      const old = b.map((entries) => entries.get(name));
      const kept = this.entry(name, byList, old, m.get(name), t.get(name));
      if (kept !== undefined) merged.set(name, kept);
    }
    const results = new Map<string, readonly Json[]>();
    for (const one of lists) {
      const { list, nameKey } = one;
      const [here, there, ...old] = [mine, theirs, ...bases].map((file) => file[list] as readonly Json[] | undefined);
      const [mineNames, theirNames, ...before] = [here, there, ...old].map((entries = []) =>
        entries.map((entry) => String(entry[nameKey])),
      );
      const kept = new Set([...mineNames, ...theirNames].filter((name) => merged.get(name)?.list === list));
      const names = this.withinLimit(
        one,
        mergeOrder(before, mineNames, theirNames, kept, (b, m, t) => {
          const key = conflictKey(ORDER, list);
          return this.value(key, `${one.many}, their order`, b, m, t) as string[];
        }),
        [old[0], here, there],
      );
      // an empty list and none are the same level, but differ as text
      const sides = isSame(old[0], here) ? [there] : isSame(old[0], there) ? [here] : [here, there];
      if (names.length > 0 || sides.some((side) => side?.length === 0))
        results.set(
          list,
          names.map((name) => (merged.get(name) as Listed).entry),
        );
    }
    return results;
  }

  private isDoubtful(key: string): boolean {
    return this.doubtful.some((one) => one === key || key.startsWith(`${one}/`) || one.startsWith(`${key}/`));
  }

  /** @returns the value of the chosen side */
  private conflict(conflict: Conflict): unknown {
    this.conflicts.push(conflict);
    return this.choices.get(conflict.key) === 'theirs' ? conflict.theirs : conflict.mine;
  }

  /** Merges one object or run, which may be missing in each version. */
  private entry(
    name: string,
    lists: ReadonlyMap<string, MergedList>,
    old: readonly (Listed | undefined)[],
    here: Listed | undefined,
    there: Listed | undefined,
  ): Listed | undefined {
    const isNew = old.every((before) => before === undefined);
    if (here !== undefined && there !== undefined && !isNew) {
      const list = this.listOf(name, old, here, there);
      const { one, together } = lists.get(list ?? here.list) as MergedList;
      if (list !== null) {
        const before = this.conflicts.length;
        const fields = old.map((listed) => listed?.entry ?? {});
        const entry = this.fields([list, name], `${one} ${name}`, together, fields, here.entry, there.entry);
        if (here.list === there.list || fits(list, entry)) return { list, entry };
        this.conflicts.length = before;
      }
    }
    // added, deleted, or of a new kind that lacks what the other side changed: merged as a whole
    const places = [old.find((before) => before !== undefined), here, there].flatMap((listed) => listed?.list ?? []);
    const list = isNew ? [...places].sort()[0] : places[0];
    const { one } = lists.get(list) as MergedList;
    const shown = (listed: Listed | undefined) => inList(list, listed);
    return listedIn(list, this.value(conflictKey(list, name), `${one} ${name}`, old.map(shown), shown(here), shown(there)));
  }

  /** The list that an object belongs to after the merge; null if both sides moved it to different ones. */
  private listOf(name: string, old: readonly (Listed | undefined)[], here: Listed, there: Listed): string | null {
    if (here.list === there.list) return here.list;
    if (old.some((before) => before !== undefined && this.isDoubtful(conflictKey(before.list, name)))) return null;
    if (old.some((before) => before?.list === there.list)) return here.list;
    return old.every((before) => before?.list === here.list) ? there.list : null;
  }

  /** Both sides together may have added more entries than a level can have: then one side's list stands. */
  private withinLimit(
    { list, many, nameKey, most }: MergedList,
    names: readonly string[],
    [base, mine, theirs]: readonly (readonly Json[] | undefined)[],
  ): readonly string[] {
    if (names.length <= most) return names;
    const chosen = this.conflict({ key: list, what: `${many}, more than ${most} together`, base, mine, theirs });
    const allowed = new Set(((chosen ?? []) as readonly Json[]).map((entry) => String(entry[nameKey])));
    return names.filter((name) => allowed.has(name));
  }
}

/** Merges what earlier merges left undecided: an entry goes once one side has removed it. */
function mergeUndecided(base: LevelFile, mine: LevelFile, theirs: LevelFile): FileConflict[] {
  const [b, m, t] = [base, mine, theirs].map(({ conflicts = [] }) => new Map(conflicts.map((one) => [one.key, one])));
  const kept: FileConflict[] = [];
  for (const key of keysInOrder(b.keys(), m.keys(), t.keys())) {
    const [old, here, there] = [b.get(key), m.get(key), t.get(key)];
    if (here !== undefined && there !== undefined) kept.push(isSame(here, old) ? there : here);
    else if (!isSame(old, here ?? there)) kept.push((here ?? there) as FileConflict);
  }
  return kept;
}

/** Keys that the base leaves undecided and both sides have decided since, on their own. */
function doubtfulKeys(base: LevelFile, mine: LevelFile, theirs: LevelFile): string[] {
  const open = new Set([...(mine.conflicts ?? []), ...(theirs.conflicts ?? [])].map(({ key }) => key));
  return (base.conflicts ?? []).map(({ key }) => key).filter((key) => !open.has(key));
}

/**
 * Merges two changed versions of a level. Changes made on one side only are taken. Objects are identified by id and runs by
 * name, so their position in a list does not matter, and an object may change its kind. A property that both sides changed
 * differently is a conflict.
 * @param base the version that both started from; all objects have ids, as in `mine` and `theirs`. null: there is none
 * @param sent states of mine that were sent and that theirs may have started from instead: a value that occurs in one of them
 * is no change of theirs, and mine counts as unchanged only if it equals all of them
 */
export function mergeLevels(
  base: LevelFile | null,
  mine: LevelFile,
  theirs: LevelFile,
  choices: Choices = new Map(),
  sent: readonly LevelFile[] = [],
): Merged {
  const before = base ?? ({} as LevelFile);
  const merge = new Merge(choices, doubtfulKeys(before, mine, theirs));
  const lists: readonly string[] = [...OBJECTS, RUNS].map(({ list }) => list);
  const merged: Record<string, unknown> = {};
  const [m, t, ...b] = [mine, theirs, before, ...sent] as unknown as Json[];
  for (const key of keysInOrder(Object.keys(before), Object.keys(m), Object.keys(t))) {
    if (key === 'conflicts' || lists.includes(key)) continue;
    const old = b.map((file) => file[key]);
    const single = SINGLE_KINDS.find((kind) => kind === key);
    const [here, there] = [m[key], t[key]] as [Json, Json];
    const value =
      single !== undefined
        ? merge.fields(
            [key],
            KINDS[single].one,
            togetherIn(single),
            old.map((one) => (one ?? {}) as Json),
            here,
            there,
          )
        : SETTINGS.includes(key)
          ? merge.optionalFields(key, old as Json[], here, there)
          : merge.value(conflictKey(key), key, old, here, there);
    if (value !== undefined) merged[key] = value;
  }
  const undecided = mergeUndecided(before, mine, theirs);
  if (undecided.length > 0) merged.conflicts = undecided;
  for (const group of [OBJECTS, [RUNS]]) for (const [list, entries] of merge.lists(group, b, m, t)) merged[list] = entries;
  return { file: merged as LevelFile, conflicts: merge.conflicts };
}

/**
 * Merges the notes of a run, note by note: each side's additions and removals are taken. A note that is moved or reworded counts
 * as removed and added, so what both sides make of one note stays twice and nothing is lost.
 * @returns null where one side's list stands as it is, or both together have more notes than a run can have
 */
function mergeNotes(bases: readonly unknown[], mine: unknown, theirs: unknown): { readonly notes: unknown } | null {
  const isWhole = isSame(mine, theirs) || bases.some((base) => isSame(base, theirs)) || bases.every((base) => isSame(base, mine));
  if (isWhole) return null;
  const [m, t, ...b] = [mine, theirs, ...bases].map((list) => namedNotes((list ?? []) as readonly RunNote[]));
  const isKept = (name: string): boolean => {
    const [here, there] = [m.has(name), t.has(name)];
    // a side that differs from the base has changed it
    return here === there || b.some((notes) => notes.has(name) === there) ? here : there;
  };
  const before = b[0] ?? new Map<string, RunNote>();
  const fresh = [...new Set([...m.keys(), ...t.keys()])].filter((name) => !before.has(name)).sort();
  const kept = [...before.keys(), ...fresh].filter(isKept);
  const notes = notesInOrder(kept.map((name) => (before.get(name) ?? m.get(name) ?? t.get(name)) as RunNote));
  if (notes.length > LIMITS.notes) return null;
  const isLeftOut = notes.length === 0 && (mine === undefined || theirs === undefined);
  return { notes: isLeftOut ? undefined : notes };
}
