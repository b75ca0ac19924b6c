import { plural } from '../../../check/words/index.ts';
import type { Hold } from '../../../schema/index.ts';

/** A press or release that is at another tick. */
export interface MovedEdge {
  readonly edge: 'press' | 'release';
  /** The hold that it belongs to, from 0, in the later version. */
  readonly hold: number;
  /** Ticks. */
  readonly before: number;
  readonly after: number;
}

/** What changed between two lists of holds. */
export interface HoldsChange {
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

/** Finds which holds were kept, moved, added and removed. */
export function compareHolds(before: readonly Hold[], after: readonly Hold[]): HoldsChange {
  const isSame = (b: Hold, a: Hold): boolean => b[0] === a[0] && b[1] === a[1];
  const shorter = Math.min(before.length, after.length);
  let head = 0;
  while (head < shorter && isSame(before[head], after[head])) head++;
  let tail = 0;
  while (tail < shorter - head && isSame(before[before.length - 1 - tail], after[after.length - 1 - tail])) tail++;
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
  return { moved, removed: others(b, keptBefore), added: others(a, keptAfter) };
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

/** More moved edges than this are counted and not listed. */
const MOST_EDGES = 6;

/** The changes of holds in words: `press 2 is 4 ticks later`, `hold 3 added (130-188)`. */
export function holdsClauses(before: readonly Hold[], after: readonly Hold[]): string[] {
  const { moved, removed, added } = compareHolds(before, after);
  const clauses: string[] = [];
  const by = moved.map((edge) => edge.after - edge.before);
  const isAll = moved.length === 2 * after.length && moved.length > 2 && removed.length + added.length === 0;
  if (isAll && by.every((ticks) => ticks === by[0])) clauses.push(`every press and release is ${shiftInWords(by[0])}`);
  else if (moved.length > MOST_EDGES) {
    const most = Math.max(...by.map(Math.abs));
    clauses.push(`${moved.length} presses and releases moved by up to ${plural(most, 'tick')}`);
  } else {
    for (const { edge, hold, before: b, after: a } of moved) clauses.push(`${edge} ${hold + 1} is ${shiftInWords(a - b)}`);
  }
  const list = (what: string, indices: readonly number[], holds: readonly Hold[]): void => {
    if (indices.length > MOST_EDGES) clauses.push(`${indices.length} holds ${what}`);
    else for (const i of indices) clauses.push(`hold ${i + 1} ${what} (${holds[i][0]}-${holds[i][1]})`);
  };
  list('removed', removed, before);
  list('added', added, after);
  return clauses;
}

const shiftInWords = (ticks: number): string => `${plural(Math.abs(ticks), 'tick')} ${ticks > 0 ? 'later' : 'earlier'}`;
