import { KINDS, kindOfList, LIMITS, OBJECT_LISTS, type ObjectKind } from '../../schema/index.ts';

export type Json = { readonly [key: string]: unknown };

/** Groups, by the fields they contain. */
export type Together = ReadonlyMap<string, string>;

export const ALONE: Together = new Map();

/** Fields of a kind that belong together: the coordinates of a place must not be mixed from two versions. */
export function togetherIn(kind: ObjectKind): Together {
  const { places, vectors } = KINDS[kind];
  const groups = [...places.map((pair, i) => [i === 0 ? 'place' : `place ${i + 1}`, pair] as const), ...Object.entries(vectors)];
  return new Map(groups.flatMap(([group, pair]) => pair.map((field) => [field, group] as const)));
}

/** A list whose entries have names. */
export interface MergedList {
  readonly list: string;
  /** A single entry in words. */
  readonly one: string;
  readonly many: string;
  /** The field with the name. */
  readonly nameKey: string;
  readonly together: Together;
  /** The largest length. */
  readonly most: number;
}

/** The lists of objects. An id belongs to one object of the level, so an object may change from one list to another. */
export const OBJECTS: readonly MergedList[] = OBJECT_LISTS.map((list) => {
  const kind = kindOfList(list);
  const { one, many } = KINDS[kind];
  return { list, one, many, nameKey: 'id', together: togetherIn(kind), most: LIMITS.objects };
});

export const RUNS: MergedList = {
  list: 'runs',
  one: 'run',
  many: 'runs',
  nameKey: 'name',
  together: ALONE,
  most: LIMITS.runs,
};

/** An entry of a list, with the list's name. */
export interface Listed {
  readonly list: string;
  readonly entry: Json;
}

/** Names the kind of an object that does not belong to a list, so that the value alone says what it is. */
export function inList(list: string, listed: Listed | undefined): Json | undefined {
  if (listed === undefined || listed.list === list) return listed?.entry;
  return { kind: kindOfList(listed.list as never), ...listed.entry };
}

/** Undoes `inList`. @returns undefined for nothing, and for a kind that no list has */
export function listedIn(list: string, value: unknown): Listed | undefined {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) return undefined;
  const { kind, ...entry } = value as Json;
  if (kind === undefined) return { list, entry: value as Json };
  const other = OBJECT_LISTS.find((list) => kindOfList(list) === kind);
  return other === undefined ? undefined : { list: other, entry };
}

/** An object with its fields in groups; a group is an object of its fields. */
export function toGroups(object: Json, together: Together): Map<string, unknown> {
  const groups = new Map<string, unknown>();
  for (const [key, value] of Object.entries(object)) {
    if (value === undefined) continue;
    const group = together.get(key);
    if (group === undefined) groups.set(key, value);
    else groups.set(group, { ...(groups.get(group) as object | undefined), [key]: value });
  }
  return groups;
}

/** Undoes `toGroups`. */
export function fromGroups(groups: ReadonlyMap<string, unknown>, together: Together): Json {
  const object: Record<string, unknown> = {};
  const names = new Set(together.values());
  for (const [group, value] of groups) {
    if (names.has(group)) Object.assign(object, value);
    else object[group] = value;
  }
  return object;
}

/** Which of two lists of texts comes first: a fixed order, which does not depend on who is called mine. */
function compareLists(p: readonly string[], q: readonly string[]): number {
  for (let i = 0; i < p.length && i < q.length; i++) if (p[i] !== q[i]) return p[i] < q[i] ? -1 : 1;
  return p.length - q.length;
}

/** Names that are not common to all, by the common name that they follow; null for those before the first. */
function followers(
  list: readonly string[],
  isCommon: (name: string) => boolean,
  kept: ReadonlySet<string>,
): Map<string | null, string[]> {
  const after = new Map<string | null, string[]>();
  let anchor: string | null = null;
  for (const name of list) {
    if (isCommon(name)) anchor = name;
    else if (kept.has(name)) {
      const group = after.get(anchor);
      if (group === undefined) after.set(anchor, [name]);
      else group.push(name);
    }
  }
  return after;
}

/**
 * Puts entries of two versions of a list into one order. Entries that only some versions have go where their version has them.
 * @param choose merges the order of the entries that all versions have
 * @param kept the names of the entries that the result has; each is in `mine` or `theirs`
 */
export function mergeOrder(
  bases: readonly (readonly string[])[],
  mine: readonly string[],
  theirs: readonly string[],
  kept: ReadonlySet<string>,
  choose: (bases: readonly string[][], mine: string[], theirs: string[]) => readonly string[],
): string[] {
  const all = [mine, theirs, ...bases].map((names) => new Set(names));
  const isCommon = (name: string) => kept.has(name) && all.every((names) => names.has(name));
  const [m, t, ...b] = [mine, theirs, ...bases].map((list) => list.filter(isCommon));
  const [hereAfter, thereAfter] = [followers(mine, isCommon, kept), followers(theirs, isCommon, kept)];
  const result = new Set<string>();
  for (const anchor of [null, ...choose(b, m, t)]) {
    if (anchor !== null) result.add(anchor);
    const groups = [hereAfter.get(anchor) ?? [], thereAfter.get(anchor) ?? []];
    groups.sort(compareLists);
    for (const name of groups.flat()) result.add(name);
  }
  return [...result];
}

/** The keys of two versions of an object: those of the base first, in its order, and then the new ones, sorted. */
export function keysInOrder(base: Iterable<string>, mine: Iterable<string>, theirs: Iterable<string>): string[] {
  const all = new Set([...mine, ...theirs]);
  const old = new Set([...base].filter((key) => all.has(key)));
  return [...old, ...[...all].filter((key) => !old.has(key)).sort()];
}
