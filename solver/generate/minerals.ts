import type { Random } from '../random.ts';
import { bodiesOf, type Disc, distance, type Layout, tryOften } from './layout.ts';
import type { Way } from './tube.ts';
import type { Wish } from './wish.ts';

const RADIUS = 7;

/** px between two minerals, and from one to the start: each is a thing of its own to get. */
const APART = 60;

// px between a mineral and what is drawn solid
const GAP = 8;

// px that a mineral may lie off the middle of the way on which she passes: half her box's width, so she touches it
const BESIDE = 10;

/** Puts a mineral on each of the ways, where there is room for it on that way. */
export function placeMinerals(layout: Layout, wish: Wish, ways: readonly Way[], random: Random): Layout {
  let grown = layout;
  for (const way of ways) {
    const mineral = tryOften(() => {
      const at = way[random.below(way.length)];
      const disc = {
        x: Math.round(at.x) + random.below(2 * BESIDE + 1) - BESIDE,
        y: Math.round(at.y) + random.below(2 * BESIDE + 1) - BESIDE,
        radius: RADIUS,
      };
      return hasRoom(grown, wish, disc) ? disc : null;
    });
    if (mineral !== null) grown = { ...grown, minerals: [...grown.minerals, mineral] };
  }
  return grown;
}

function hasRoom(layout: Layout, wish: Wish, disc: Disc): boolean {
  const { x, y } = disc;
  if (x < 20 || y < 20 || x > wish.width - 20 || y > wish.height - 20) return false;
  if ([layout.start, ...layout.minerals].some((other) => distance(other, disc) < APART)) return false;
  return bodiesOf(layout).every((body) => distance(body, disc) >= body.radius + RADIUS + GAP);
}
