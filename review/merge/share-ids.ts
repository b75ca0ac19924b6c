import { type LevelFile, OBJECT_LISTS, type ObjectList, withIds } from '../../schema/index.ts';

type Entry = { readonly id?: string | undefined; readonly [key: string]: unknown };

/** Objects of a side, by index: the index of the same object in the base. */
type Pairs = ReadonlyMap<number, number>;

/** Larger gaps are not searched for objects that have changed little: pairs of objects. */
const MOST_COMPARED = 1e6;

const contentOf = ({ id: _, ...rest }: Entry): string =>
  JSON.stringify(Object.entries(rest).sort(([p], [q]) => (p < q ? -1 : 1)));

/** The share of fields that are equal. */
function likeness(a: Entry, b: Entry): number {
  const keys = [...new Set([...Object.keys(a), ...Object.keys(b)])].filter((key) => key !== 'id');
  const equal = keys.filter((key) => JSON.stringify(a[key]) === JSON.stringify(b[key]));
  return equal.length / keys.length;
}

/**
 * Finds the objects of a base in a changed version, where an object may lack an id: by id, then by content, then by place in
 * the list: an object between the same neighbours.
 * @param written whether an object of the base has an id in its file, and not only one from its content
 */
function pairUp(base: readonly Entry[], written: readonly boolean[], side: readonly Entry[]): Pairs {
  const pairs = new Map<number, number>();
  const free = new Set(base.keys());
  const pair = (i: number, j: number) => {
    pairs.set(i, j);
    free.delete(j);
  };
  const mayBe = (i: number, j: number) => side[i].id === undefined || !written[j];
  const byId = new Map(base.map(({ id }, j) => [id, j]));
  for (const [i, { id }] of side.entries()) {
    const j = id === undefined ? undefined : byId.get(id);
    if (j !== undefined) pair(i, j);
  }
  // where objects are equal, those that have not changed their places are the same ones
  for (const i of side.keys())
    if (!pairs.has(i) && free.has(i) && mayBe(i, i) && contentOf(side[i]) === contentOf(base[i])) pair(i, i);
  const byContent = new Map<string, number[]>();
  for (const j of free) {
    const content = contentOf(base[j]);
    byContent.set(content, [...(byContent.get(content) ?? []), j]);
  }
  for (const [i, entry] of side.entries()) {
    if (pairs.has(i)) continue;
    const same = byContent.get(contentOf(entry));
    const j = same?.find((one) => mayBe(i, one));
    if (j === undefined) continue;
    same?.splice(same.indexOf(j), 1);
    pair(i, j);
  }
  // what is left lies between objects that both have
  const partner = new Map([...pairs].map(([i, j]) => [j, i]));
  const inGaps = new Map<number, number[]>();
  let before = -1;
  for (const j of base.keys()) {
    if (!free.has(j)) before = partner.get(j) as number;
    else inGaps.set(before, [...(inGaps.get(before) ?? []), j]);
  }
  const gaps = new Map<number, number[]>();
  before = -1;
  for (const i of side.keys()) {
    if (pairs.has(i)) before = i;
    else gaps.set(before, [...(gaps.get(before) ?? []), i]);
  }
  for (const [gap, here] of gaps) {
    const there = inGaps.get(gap) ?? [];
    const isEven = there.length === here.length;
    if (!isEven && there.length * here.length > MOST_COMPARED) continue;
    let next = 0;
    for (const i of here) {
      // as many as before: the same ones, changed; otherwise only those that have changed little
      const at = isEven ? next : there.findIndex((j, n) => n >= next && likeness(side[i], base[j]) >= 0.5);
      if (at < 0) continue;
      next = at + 1;
      if (mayBe(i, there[at])) pair(i, there[at]);
    }
  }
  return pairs;
}

const isUnique = (file: LevelFile): boolean => {
  const ids = OBJECT_LISTS.flatMap((list) => (file[list] ?? []).map(({ id }) => id)).filter((id) => id !== undefined);
  return new Set(ids).size === ids.length;
};

/**
 * Gives every object of the versions of a level an id, so that they can be merged: an object that lacks one in some version
 * gets the same id in all of them, even where it was changed.
 * @param base the version that both started from; null: there is none
 */
export function shareIds(
  base: LevelFile | null,
  mine: LevelFile,
  theirs: LevelFile,
): { readonly base: LevelFile | null; readonly mine: LevelFile; readonly theirs: LevelFile } {
  const plain = { base: base === null ? null : withIds(base), mine: withIds(mine), theirs: withIds(theirs) };
  if (base === null || plain.base === null) return plain;
  const [b, m, t] = [{ ...plain.base }, { ...mine }, { ...theirs }];
  const listOf = (file: LevelFile, list: ObjectList) => (file[list] ?? []) as readonly Entry[];
  for (const list of OBJECT_LISTS) {
    const written = listOf(base, list).map(({ id }) => id !== undefined);
    const old = listOf(plain.base, list);
    const sides = [m, t].map((file) => ({ file, pairs: pairUp(old, written, listOf(file, list)) }));
    // an id that a side has given to an object meanwhile is the object's
    const given = new Map<number, string>();
    for (const { file, pairs } of sides)
      for (const [i, j] of pairs) {
        const { id } = listOf(file, list)[i];
        const other = given.get(j);
        if (id !== undefined && id !== old[j].id && (other === undefined || id < other)) given.set(j, id);
      }
    const shared = old.map((entry, j) => ({ ...entry, id: given.get(j) ?? entry.id }));
    if (base[list] !== undefined) b[list] = shared as never;
    for (const { file, pairs } of sides)
      if (file[list] !== undefined)
        file[list] = listOf(file, list).map((entry, i) => {
          const j = pairs.get(i);
          return j === undefined ? entry : { ...entry, id: shared[j].id };
        }) as never;
  }
  if (![b, m, t].every(isUnique)) return plain;
  return { base: b, mine: withIds(m), theirs: withIds(t) };
}
