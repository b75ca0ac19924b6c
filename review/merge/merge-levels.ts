import { isSame, KINDS, kindOfList, type LevelFile, OBJECT_LISTS, type ObjectKind, SINGLE_KINDS } from '../../schema/index.ts';

export type Side = 'mine' | 'theirs';

/** A property that both sides changed in different ways. */
export interface Conflict {
  /** Identifies what it is about, for choices: `asteroids/a7k2/place`, `runs/solution/holds`, `name`. */
  readonly key: string;
  /** The same in words: `asteroid a7k2, place`. */
  readonly what: string;
  /** JSON values; undefined if missing or deleted. */
  readonly base: unknown;
  readonly mine: unknown;
  readonly theirs: unknown;
}

export type Choices = ReadonlyMap<string, Side>;

export interface Merged {
  readonly file: LevelFile;
  /** All conflicts, resolved or not; unresolved ones are mine in `file`. */
  readonly conflicts: readonly Conflict[];
}

type Json = { readonly [key: string]: unknown };

/** Groups, by the fields they contain. */
type Together = ReadonlyMap<string, string>;

const ALONE: Together = new Map();

/** Fields of a kind that belong together: the coordinates of a place must not be mixed from two versions. */
function togetherIn(kind: ObjectKind): Together {
  const { places, vectors } = KINDS[kind];
  const groups = [...places.map((pair, i) => [i === 0 ? 'place' : `place ${i + 1}`, pair] as const), ...Object.entries(vectors)];
  return new Map(groups.flatMap(([group, pair]) => pair.map((field) => [field, group] as const)));
}

/** An object with its fields in groups; a group is an object of its fields. */
function toGroups(object: Json, together: Together): Map<string, unknown> {
  const groups = new Map<string, unknown>();
  for (const [key, value] of Object.entries(object)) {
    if (value === undefined) continue;
    const group = together.get(key);
    if (group === undefined) groups.set(key, value);
    else groups.set(group, { ...(groups.get(group) as object | undefined), [key]: value });
  }
  return groups;
}

function fromGroups(groups: ReadonlyMap<string, unknown>, together: Together): Json {
  const object: Record<string, unknown> = {};
  const names = new Set(together.values());
  for (const [group, value] of groups) {
    if (names.has(group)) Object.assign(object, value);
    else object[group] = value;
  }
  return object;
}

/** A list whose entries have names. */
interface MergedList {
  readonly list: string;
  /** A single entry in words. */
  readonly kind: string;
  /** The field with the name. */
  readonly nameKey: string;
  readonly together: Together;
}

class Merge {
  readonly conflicts: Conflict[] = [];

  constructor(private readonly choices: Choices) {}

  /** Merges one value as a whole. */
  value(key: string, what: string, bases: readonly unknown[], mine: unknown, theirs: unknown): unknown {
    if (isSame(mine, theirs) || bases.some((base) => isSame(base, theirs))) return mine;
    if (bases.every((base) => isSame(base, mine))) return theirs;
    this.conflicts.push({ key, what, base: bases[0], mine, theirs });
    return this.choices.get(key) === 'theirs' ? theirs : mine;
  }

  fields(key: string, what: string, together: Together, bases: readonly Json[], mine: Json, theirs: Json): Json {
    const [m, t, ...b] = [mine, theirs, ...bases].map((object) => toGroups(object, together));
    const merged = new Map<string, unknown>();
    for (const field of new Set([...m.keys(), ...t.keys()])) {
      const old = b.map((groups) => groups.get(field));
      const value = this.value(`${key}/${field}`, `${what}, ${field}`, old, m.get(field), t.get(field));
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
    const merged = this.fields(key, key, ALONE, before, mine ?? {}, theirs ?? {});
    if (Object.keys(merged).length > 0) return merged;
    const sides = isSame(bases[0], mine) ? [theirs] : isSame(bases[0], theirs) ? [mine] : [mine, theirs];
    return sides.some((side) => side !== undefined && Object.keys(side).length === 0) ? merged : undefined;
  }

  /** Merges a list whose entries have names: objects by id, runs by name. */
  list(
    key: string,
    { kind, nameKey, together }: MergedList,
    bases: readonly (readonly Json[])[],
    mine: readonly Json[],
    theirs: readonly Json[],
  ): Json[] {
    const byName = (list: readonly Json[]) => new Map(list.map((entry) => [String(entry[nameKey]), entry]));
    const [m, t, ...b] = [mine, theirs, ...bases].map(byName);
    const merged = new Map<string, Json>();
    for (const name of new Set([...m.keys(), ...t.keys()])) {
      const [here, there] = [m.get(name), t.get(name)];
      const old = b.map((entries) => entries.get(name));
      const what = `${kind} ${name}`;
      if (here !== undefined && there !== undefined) {
        const fields = old.map((entry) => entry ?? {});
        merged.set(name, this.fields(`${key}/${name}`, what, together, fields, here, there));
        continue;
      }
      // added on one side, or deleted on the other
      const kept = this.value(`${key}/${name}`, what, old, here, there) as Json | undefined;
      if (kept !== undefined) merged.set(name, kept);
    }
    const before = b.map((entries) => [...entries.keys()]);
    const names = this.order(key, kind, before, [...m.keys()], [...t.keys()], new Set(merged.keys()));
    return names.map((name) => merged.get(name) as Json);
  }

  /** The order of the kept entries: that of the side that changed it; new entries go where their side has them. */
  private order(
    key: string,
    kind: string,
    bases: readonly (readonly string[])[],
    mine: readonly string[],
    theirs: readonly string[],
    kept: ReadonlySet<string>,
  ): string[] {
    const all = [mine, theirs, ...bases].map((names) => new Set(names));
    const isCommon = (name: string) => all.every((names) => names.has(name));
    const [m, t, ...b] = [mine, theirs, ...bases].map((list) => list.filter(isCommon));
    const common = this.value(`${key}/order`, `${kind}s, their order`, b, m, t) as string[];
    const [hereAfter, thereAfter] = [followers(mine, isCommon, kept), followers(theirs, isCommon, kept)];
    const placed = new Set<string>();
    const result: string[] = [];
    const put = (name: string) => {
      if (placed.has(name)) return;
      placed.add(name);
      result.push(name);
    };
    for (const anchor of ['', ...common]) {
      if (anchor !== '') put(anchor);
      const groups = [hereAfter.get(anchor) ?? [], thereAfter.get(anchor) ?? []];
      // the result must not depend on which side is called mine
      groups.sort((p, q) => (p.join() < q.join() ? -1 : 1));
      for (const name of groups.flat()) put(name);
    }
    return result;
  }
}

/** Names that are not common to all, by the common name that they follow; '' for those before the first. */
function followers(
  list: readonly string[],
  isCommon: (name: string) => boolean,
  kept: ReadonlySet<string>,
): Map<string, string[]> {
  const after = new Map<string, string[]>();
  let anchor = '';
  for (const name of list) {
    if (isCommon(name)) anchor = name;
    else if (kept.has(name)) after.set(anchor, [...(after.get(anchor) ?? []), name]);
  }
  return after;
}

const LISTS: readonly MergedList[] = [
  ...OBJECT_LISTS.map((list) => {
    const kind = kindOfList(list);
    return { list, kind: KINDS[kind].one, nameKey: 'id', together: togetherIn(kind) };
  }),
  { list: 'runs', kind: 'run', nameKey: 'name', together: ALONE },
];

/**
 * Merges two changed versions of a level. Changes made on one side only are taken. Objects are identified by id and runs by
 * name, so their position in a list does not matter. A property that both sides changed differently is a conflict.
 * @param base the version that both started from; all objects have ids, as in `mine` and `theirs`
 * @param sent states of mine that were sent and that theirs may have started from instead: a value that occurs in one of them
 * is no change of theirs, and mine counts as unchanged only if it equals all of them
 */
export function mergeLevels(
  base: LevelFile,
  mine: LevelFile,
  theirs: LevelFile,
  choices: Choices = new Map(),
  sent: readonly LevelFile[] = [],
): Merged {
  const merge = new Merge(choices);
  const lists: readonly string[] = LISTS.map(({ list }) => list);
  const merged: Record<string, unknown> = {};
  const [m, t, ...b] = [mine, theirs, base, ...sent] as unknown as Json[];
  for (const key of new Set([...Object.keys(m), ...Object.keys(t)])) {
    if (lists.includes(key)) continue;
    const old = b.map((file) => file[key]);
    const single = SINGLE_KINDS.find((kind) => kind === key);
    const fields = [old, m[key], t[key]] as [Json[], Json, Json];
    const value =
      single !== undefined
        ? merge.fields(key, KINDS[single].one, togetherIn(single), ...fields)
        : key === 'rules'
          ? merge.optionalFields(key, ...fields)
          : merge.value(key, key, old, m[key], t[key]);
    if (value !== undefined) merged[key] = value;
  }
  for (const one of LISTS) {
    const { list } = one;
    const [here, there, ...old] = [m, t, ...b].map((file) => file[list] as readonly Json[] | undefined);
    const before = old.map((entries) => entries ?? []);
    const entries = merge.list(list, one, before, here ?? [], there ?? []);
    // an empty list and none are the same level, but differ as text
    const sides = isSame(old[0], here) ? [there] : isSame(old[0], there) ? [here] : [here, there];
    if (entries.length > 0 || sides.some((side) => side?.length === 0)) merged[list] = entries;
  }
  return { file: merged as LevelFile, conflicts: merge.conflicts };
}
