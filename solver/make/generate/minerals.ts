import type { Disc } from '../../../schema/basics/index.ts';
import type { Random } from '../../random.ts';
import type { GeneratorSpec } from './generator-spec.ts';
import { bodiesOf, distance, type Layout, tryOften } from './layout.ts';
import type { Way } from './tube.ts';

/** Radius of a mineral, px. */
export const MINERAL_RADIUS = 7;

/** px between two minerals, and between a mineral and the start, so that each has to be collected on its own. */
const APART = 60;

// px between a mineral and objects that are drawn solid.
const GAP = 8;

// px between a mineral and the path on which she passes, at most: half the width of her box, so that she touches it.
const BESIDE = 10;

/** Places one mineral on each of the paths, if there is room. */
export function placeMinerals(layout: Layout, spec: GeneratorSpec, ways: readonly Way[], random: Random): Layout {
  let grown = layout;
  for (const way of ways) {
    const mineral = tryOften(() => {
      const at = way[random.below(way.length)];
      const disc = {
        x: Math.round(at.x) + random.below(2 * BESIDE + 1) - BESIDE,
        y: Math.round(at.y) + random.below(2 * BESIDE + 1) - BESIDE,
        radius: MINERAL_RADIUS,
      };
      return hasRoom(grown, spec, disc) ? disc : null;
    });
    if (mineral !== null) grown = { ...grown, minerals: [...grown.minerals, mineral] };
  }
  return grown;
}

/** Whether a mineral lies within the level and keeps its distance from everything else. */
export function hasRoom(layout: Layout, spec: GeneratorSpec, disc: Disc): boolean {
  const { x, y } = disc;
  if (x < 20 || y < 20 || x > spec.width - 20 || y > spec.height - 20) return false;
  if ([layout.start, ...layout.minerals].some((other) => distance(other, disc) < APART)) return false;
  return bodiesOf(layout).every((body) => distance(body, disc) >= body.radius + MINERAL_RADIUS + GAP);
}
