import type { Json, MatchedBy } from './change.ts';

/** An entry of the first list and the same one in the second. */
export interface Match {
  readonly before: number;
  readonly after: number;
  readonly by: MatchedBy;
}

/** What identifies the entries of a list. */
export interface Identity {
  /** The key of the field that names an entry. */
  readonly nameKey: string;
  /** The keys of its place; null if it has none. */
  readonly place: readonly [x: string, y: string] | null;
}

/** The most distances to measure. More objects without ids than that are matched in the order of their lists. */
const MOST_DISTANCES = 4_000_000;

/**
 * Finds the entries that two lists have in common: first those of equal names, then those of equal content, then the nearest
 * ones of which at least one has no name. The result does not depend on which list comes first.
 * @returns the matches, sorted by the second list
 */
export function matchEntries(before: readonly Json[], after: readonly Json[], { nameKey, place }: Identity): Match[] {
  const matches: Match[] = [];
  const [restBefore, restAfter] = [new Set(before.keys()), new Set(after.keys())];
  const match = (b: number, a: number, by: MatchedBy): void => {
    matches.push({ before: b, after: a, by });
    restBefore.delete(b);
    restAfter.delete(a);
  };

  const named = new Map<unknown, number>();
  for (const [i, entry] of before.entries()) if (entry[nameKey] !== undefined) named.set(entry[nameKey], i);
  for (const [i, entry] of after.entries()) {
    const b = entry[nameKey] === undefined ? undefined : named.get(entry[nameKey]);
    if (b !== undefined) match(b, i, 'id');
  }

  if (restBefore.size > 0 && restAfter.size > 0) {
    const byContent = new Map<string, number[]>();
    const contentOf = (entry: Json): string => {
      const { [nameKey]: _, ...content } = entry;
      return JSON.stringify(Object.entries(content).sort(([p], [q]) => (p < q ? -1 : 1)));
    };
    for (const i of restBefore) {
      const content = contentOf(before[i]);
      const same = byContent.get(content);
      if (same === undefined) byContent.set(content, [i]);
      else same.push(i);
    }
    for (const list of byContent.values()) list.reverse();
    for (const i of [...restAfter]) {
      const b = byContent.get(contentOf(after[i]))?.pop();
      if (b !== undefined) match(b, i, 'content');
    }
  }

  if (place !== null) {
    const isNameless = (entry: Json): boolean => entry[nameKey] === undefined;
    for (const [b, a] of nearest(before, after, [...restBefore], [...restAfter], place, isNameless)) match(b, a, 'place');
  }
  return matches.sort((p, q) => p.after - q.after);
}

/** Pairs of entries, the nearest first, of which at least one is nameless. */
function nearest(
  before: readonly Json[],
  after: readonly Json[],
  restBefore: readonly number[],
  restAfter: readonly number[],
  [xKey, yKey]: readonly [string, string],
  isNameless: (entry: Json) => boolean,
): [number, number][] {
  const pairs: [number, number][] = [];
  let [bs, as] = [restBefore, restAfter];
  const pointOf = (entry: Json): readonly [number, number, boolean] => [
    entry[xKey] as number,
    entry[yKey] as number,
    isNameless(entry),
  ];
  const bPoints = new Map(bs.map((i) => [i, pointOf(before[i])]));
  const aPoints = new Map(as.map((i) => [i, pointOf(after[i])]));
  let left = MOST_DISTANCES;
  while (bs.length > 0 && as.length > 0) {
    left -= bs.length * as.length;
    if (left < 0) return [...pairs, ...inOrder(bs, as, bPoints, aPoints)];
    // two that are nearest to each other are a pair; the nearest two of all are, so that every round finds one
    const [toB, toA] = [new Map<number, readonly [number, number]>(), new Map<number, readonly [number, number]>()];
    for (const b of bs) {
      const [bx, by, isFree] = bPoints.get(b)!;
      for (const a of as) {
        const [ax, ay, isOther] = aPoints.get(a)!;
        if (!isFree && !isOther) continue;
        const distance = (ax - bx) * (ax - bx) + (ay - by) * (ay - by);
        if (distance < (toA.get(b)?.[0] ?? Number.POSITIVE_INFINITY)) toA.set(b, [distance, a]);
        if (distance < (toB.get(a)?.[0] ?? Number.POSITIVE_INFINITY)) toB.set(a, [distance, b]);
      }
    }
    const found = [...toA].flatMap(([b, [, a]]): [number, number][] => (toB.get(a)?.[1] === b ? [[b, a]] : []));
    if (found.length === 0) return pairs;
    pairs.push(...found);
    const taken = [new Set(found.map(([b]) => b)), new Set(found.map(([, a]) => a))];
    bs = bs.filter((b) => !taken[0].has(b));
    as = as.filter((a) => !taken[1].has(a));
  }
  return pairs;
}

/** Pairs in the order of the lists: the nameless ones of one side with those of the other. */
function inOrder(
  bs: readonly number[],
  as: readonly number[],
  bPoints: ReadonlyMap<number, readonly [number, number, boolean]>,
  aPoints: ReadonlyMap<number, readonly [number, number, boolean]>,
): [number, number][] {
  const [b, a] = [bs.filter((i) => bPoints.get(i)![2]), as.filter((i) => aPoints.get(i)![2])];
  return Array.from({ length: Math.min(b.length, a.length) }, (_, i): [number, number] => [b[i], a[i]]);
}
