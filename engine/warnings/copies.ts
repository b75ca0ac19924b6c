import type { Level } from '../../schema/index.ts';
import type { Place } from './geometry.ts';

export const LISTS = ['asteroids', 'novae', 'repulsors', 'aliens', 'minerals'] as const;

/** For each list of a level: the objects that lie exactly where an earlier one of the list lies, and that one's index. */
export type Copies = Readonly<Record<(typeof LISTS)[number], ReadonlyMap<number, number>>>;

const NONE: ReadonlyMap<number, number> = new Map();

export const copiesOf = (level: Level): Copies => ({
  asteroids: copiesIn(level.asteroids),
  novae: copiesIn(level.novae),
  repulsors: copiesIn(level.repulsors),
  aliens: copiesIn(level.aliens),
  minerals: copiesIn(level.minerals),
});

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
