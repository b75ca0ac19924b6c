import Flatbush from 'flatbush';
import type { Disc } from '../../schema/basics/index.ts';

// for fewer discs than this, comparing all pairs is faster than building an index
const INDEX_FROM = 64;

// thousands of discs in one place have millions of pairs; beyond this many the search gives up instead of hanging
const MAX_CANDIDATES = 2_000_000;

/**
 * Yields pairs of overlapping discs of one list, the earlier in the list first. Touching from outside is no overlap. Lazy: the
 * search goes only as far as pairs are requested.
 */
export function* overlaps<T extends Disc>(discs: readonly T[]): Generator<readonly [T, T]> {
  const near = finderOf(discs);
  let candidates = 0;
  for (const [i, a] of discs.entries()) {
    for (const j of near(a)) {
      if (++candidates > MAX_CANDIDATES) return;
      if (j > i && overlap(a, discs[j])) yield [a, discs[j]];
    }
  }
}

/** Yields pairs of a disc of one list and a disc of another that overlap, in the order of the first list. Also lazy. */
export function* overlapsBetween<T extends Disc, U extends Disc>(
  discs: readonly T[],
  others: readonly U[],
): Generator<readonly [T, U]> {
  const near = finderOf(others);
  let candidates = 0;
  for (const a of discs) {
    for (const j of near(a)) {
      if (++candidates > MAX_CANDIDATES) return;
      if (overlap(a, others[j])) yield [a, others[j]];
    }
  }
}

/** Returns a function that finds the discs which may overlap a given one: their indices, ascending. */
function finderOf(discs: readonly Disc[]): (disc: Disc) => readonly number[] {
  if (discs.length < INDEX_FROM) {
    const all = [...discs.keys()];
    return () => all;
  }
  const index = new Flatbush(discs.length);
  for (const { x, y, radius } of discs) index.add(x - radius, y - radius, x + radius, y + radius);
  index.finish();
  return ({ x, y, radius }) => index.search(x - radius, y - radius, x + radius, y + radius).sort((a, b) => a - b);
}

function overlap(a: Disc, b: Disc): boolean {
  const dx = a.x - b.x;
  const dy = a.y - b.y;
  const reach = a.radius + b.radius;
  return dx * dx + dy * dy < reach * reach;
}
