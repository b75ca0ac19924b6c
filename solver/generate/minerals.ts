import type { Disc } from '../../schema/index.ts';
import type { Random } from '../random.ts';
import type { GeneratorSpec } from './generator-spec.ts';
import { bodiesOf, distance, type Layout, tryOften } from './layout.ts';
import type { Way } from './tube.ts';

const RADIUS = 7;

/** px between two minerals, and from one to the start: each is a thing of its own to get. */
const APART = 60;

// px between a mineral and what is drawn solid
const GAP = 8;

// px that a mineral may lie off the middle of the way on which she passes: half her box's width, so she touches it
const BESIDE = 10;

/** Puts a mineral on each of the ways, where there is room for it on that way. */
export function placeMinerals(layout: Layout, spec: GeneratorSpec, ways: readonly Way[], random: Random): Layout {
  let grown = layout;
  for (const way of ways) {
    const mineral = tryOften(() => {
      const at = way[random.below(way.length)];
      const disc = {
        x: Math.round(at.x) + random.below(2 * BESIDE + 1) - BESIDE,
        y: Math.round(at.y) + random.below(2 * BESIDE + 1) - BESIDE,
        radius: RADIUS,
      };
      return hasRoom(grown, spec, disc) ? disc : null;
    });
    if (mineral !== null) grown = { ...grown, minerals: [...grown.minerals, mineral] };
  }
  return grown;
}

function hasRoom(layout: Layout, spec: GeneratorSpec, disc: Disc): boolean {
  const { x, y } = disc;
  if (x < 20 || y < 20 || x > spec.width - 20 || y > spec.height - 20) return false;
  if ([layout.start, ...layout.minerals].some((other) => distance(other, disc) < APART)) return false;
  return bodiesOf(layout).every((body) => distance(body, disc) >= body.radius + RADIUS + GAP);
}
