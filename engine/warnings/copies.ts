import { type Level, OBJECT_LISTS, type ObjectList } from '../../schema/basics/index.ts';
import type { Place } from './geometry.ts';

/**
 * For each list of a level: the indices of objects at exactly the place of an earlier one in the list, each with that one's
 * index.
 */
export type Copies = Readonly<Record<ObjectList, ReadonlyMap<number, number>>>;

const NONE: ReadonlyMap<number, number> = new Map();

export const copiesOf = (level: Level): Copies =>
  Object.fromEntries(OBJECT_LISTS.map((list) => [list, copiesIn(level[list])])) as Record<
    ObjectList,
    ReadonlyMap<number, number>
  >;

function copiesIn(list: readonly Place[]): ReadonlyMap<number, number> {
  if (list.length < 2) return NONE;
  const order = [...list.keys()].sort((a, b) => list[a].x - list[b].x || list[a].y - list[b].y || a - b);
  const copies: [number, number][] = [];
  let first = order[0];
  for (const i of order.slice(1)) {
    if (list[i].x === list[first].x && list[i].y === list[first].y) copies.push([i, first]);
    else first = i;
  }
  return copies.length === 0 ? NONE : new Map(copies.sort((a, b) => a[0] - b[0]));
}
