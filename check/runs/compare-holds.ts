import { type Hold, notesInOrder, type RunNote } from '../../schema/index.ts';

/** A press or release that is at another tick. */
interface MovedEdge {
  readonly edge: 'press' | 'release';
  /** The hold that it belongs to, from 0, in the later version. */
  readonly hold: number;
  /** Ticks. */
  readonly before: number;
  readonly after: number;
}

/** What changed between two lists of holds. */
interface HoldsChange {
  /** The holds that both lists have, by index, in order of time. */
  readonly pairs: readonly (readonly [before: number, after: number])[];
  readonly moved: readonly MovedEdge[];
  /** Indices in the earlier list, from 0. */
  readonly removed: readonly number[];
  /** Indices in the later list, from 0. */
  readonly added: readonly number[];
}

/** The most pairs of holds to compare; longer runs are compared in order. */
const MOST_PAIRS = 1_000_000;

/** What a hold costs that has no counterpart, ticks: as much as one whose two edges move by half a second. */
const ALONE = 60;

/** How many entries two lists have in common at their beginnings, and at their ends. */
export function commonEnds<T>(before: readonly T[], after: readonly T[], isSame: (b: T, a: T) => boolean) {
  const shorter = Math.min(before.length, after.length);
  let head = 0;
  while (head < shorter && isSame(before[head], after[head])) head++;
  let tail = 0;
  while (tail < shorter - head && isSame(before[before.length - 1 - tail], after[after.length - 1 - tail])) tail++;
  return { head, tail };
}

/** Finds which holds were kept, moved, added and removed. */
export function compareHolds(before: readonly Hold[], after: readonly Hold[]): HoldsChange {
  const isSame = (b: Hold, a: Hold): boolean => b[0] === a[0] && b[1] === a[1];
  const { head, tail } = commonEnds(before, after, isSame);
  const [b, a] = [before.slice(head, before.length - tail), after.slice(head, after.length - tail)];
  const pairs = b.length === a.length || b.length * a.length > MOST_PAIRS ? pairsInOrder(b, a) : cheapestPairs(b, a);
  const [keptBefore, keptAfter] = [new Set(pairs.map(([i]) => i)), new Set(pairs.map(([, j]) => j))];
  const moved = pairs.flatMap(([i, j]): MovedEdge[] =>
    ([0, 1] as const).flatMap((e) =>
      b[i][e] === a[j][e]
        ? []
        : [{ edge: e === 0 ? ('press' as const) : ('release' as const), hold: head + j, before: b[i][e], after: a[j][e] }],
    ),
  );
  const others = (list: readonly Hold[], kept: ReadonlySet<number>): number[] =>
    [...list.keys()].flatMap((i) => (kept.has(i) ? [] : [head + i]));
  const same = (count: number, from: readonly [number, number]): [number, number][] =>
    Array.from({ length: count }, (_, i) => [from[0] + i, from[1] + i]);
  return {
    pairs: [
      ...same(head, [0, 0]),
      ...pairs.map(([i, j]): [number, number] => [head + i, head + j]),
      ...same(tail, [before.length - tail, after.length - tail]),
    ],
    moved,
    removed: others(b, keptBefore),
    added: others(a, keptAfter),
  };
}

const pairsInOrder = (b: readonly Hold[], a: readonly Hold[]): [number, number][] =>
  Array.from({ length: Math.min(b.length, a.length) }, (_, i): [number, number] => [i, i]);

/** The pairing in order of time for which edges move least. */
function cheapestPairs(b: readonly Hold[], a: readonly Hold[]): [number, number][] {
  const width = a.length + 1;
  const cost = new Float64Array((b.length + 1) * width);
  const together = (i: number, j: number): number => Math.abs(b[i][0] - a[j][0]) + Math.abs(b[i][1] - a[j][1]);
  for (let i = b.length; i >= 0; i--) {
    for (let j = a.length; j >= 0; j--) {
      if (i === b.length) cost[i * width + j] = ALONE * (a.length - j);
      else if (j === a.length) cost[i * width + j] = ALONE * (b.length - i);
      else {
        const pair = cost[(i + 1) * width + j + 1] + together(i, j);
        cost[i * width + j] = Math.min(pair, ALONE + cost[(i + 1) * width + j], ALONE + cost[i * width + j + 1]);
      }
    }
  }
  const pairs: [number, number][] = [];
  for (let i = 0, j = 0; i < b.length && j < a.length; ) {
    const least = cost[i * width + j];
    if (least === cost[(i + 1) * width + j + 1] + together(i, j)) pairs.push([i++, j++]);
    else if (least === ALONE + cost[(i + 1) * width + j]) i++;
    else j++;
  }
  return pairs;
}

/** The first tick at which two scripts of holds differ; infinite if they are equal. Both must be sorted and disjoint. */
export function firstDifference(a: readonly Hold[], b: readonly Hold[]): number {
  for (let i = 0; i < Math.max(a.length, b.length); i++) {
    if (i >= a.length) return b[i][0];
    if (i >= b.length) return a[i][0];
    if (a[i][0] !== b[i][0]) return Math.min(a[i][0], b[i][0]);
    if (a[i][1] !== b[i][1]) return Math.min(a[i][1], b[i][1]);
  }
  return Number.POSITIVE_INFINITY;
}

/**
 * The notes of a run whose holds are replaced. A note at the press or release of a hold that is kept goes along with it; one
 * inside a hold goes along if the whole hold moves; any other stays at its tick. None is dropped.
 * @param before sorted and disjoint
 * @param after likewise
 */
export function carryNotes<T extends RunNote>(notes: readonly T[], before: readonly Hold[], after: readonly Hold[]): T[] {
  if (notes.length === 0) return [];
  const kept = new Map(compareHolds(before, after).pairs.map(([b, a]) => [before[b], after[a]]));
  const carried = (tick: number): number => {
    const hold = before.find(([press, release]) => press <= tick && tick <= release);
    const now = hold === undefined ? undefined : kept.get(hold);
    if (hold === undefined || now === undefined) return tick;
    if (tick === hold[0]) return now[0];
    if (tick === hold[1]) return now[1];
    return now[0] - hold[0] === now[1] - hold[1] ? tick + now[0] - hold[0] : tick;
  };
  return notesInOrder(notes.map((note) => ({ ...note, tick: carried(note.tick) })));
}
