import { boxOf } from '../../../engine/index.ts';
import { type Disc, type Place, rulesOf } from '../../../schema/basics/index.ts';
import type { Random } from '../../random.ts';
import type { GeneratorSpec } from './generator-spec.ts';
import { bodiesOf, distance, fits, type Layout, NOVA_MARGIN, tryOften } from './layout.ts';
import { distanceToWays, type Way } from './tube.ts';

const RADII = [16, 32] as const;

// px by which her box overlaps the smallest nova beside a path, at least.
const OVERLAP = 6;

/** Offsets from a path, whole px: on it, and beside it where she still touches the smallest nova at any angle of her box. */
function offsetsOf(layout: Layout): readonly (readonly [number, number])[] {
  const { halfWidth, halfHeight } = boxOf(rulesOf(layout));
  const beside = Math.floor(RADII[0] + Math.min(halfWidth, halfHeight)) - OVERLAP;
  return [
    [0, 0],
    [beside, 0],
    [-beside, 0],
    [0, beside],
    [0, -beside],
  ];
}

/**
 * Adds up to `count` novae that leave all `free` paths open: two of three near a path, where they matter, the others anywhere.
 */
export function addNovae(layout: Layout, spec: GeneratorSpec, free: readonly Way[], count: number, random: Random): Layout {
  let grown = layout;
  for (let i = 0; i < count; i++) {
    const radius = RADII[random.below(RADII.length)];
    const isNear = random.below(3) < 2;
    const nova = tryOften(() => {
      const place = isNear ? beside(free[0], random) : { x: random.below(spec.width), y: random.below(spec.height) };
      return freeNova(grown, spec, free, { ...place, radius });
    });
    if (nova !== null) grown = { ...grown, novae: [...grown.novae, nova] };
  }
  return grown;
}

/**
 * Puts a nova on a path that is too easy, if that leaves all `free` paths open: on one of the `slots` where one will do. null where
 * there is no such place.
 */
export function blockWay(
  layout: Layout,
  spec: GeneratorSpec,
  free: readonly Way[],
  shortcut: Way,
  random: Random,
  slots: readonly Disc[] = [],
): Layout | null {
  const places: Disc[] = [];
  const offsets = offsetsOf(layout);
  for (const slot of slots) {
    if (distanceToWays([shortcut], slot) <= slot.radius + offsets[1][0] - RADII[0] && freeNova(layout, spec, free, slot) !== null)
      places.push(slot);
  }
  if (places.length > 0) return { ...layout, novae: [...layout.novae, places[random.below(places.length)]] };
  for (const at of shortcut) {
    for (const [dx, dy] of offsets) {
      const nova = freeNova(layout, spec, free, { x: Math.round(at.x) + dx, y: Math.round(at.y) + dy, radius: RADII[0] });
      if (nova !== null) places.push(nova);
    }
  }
  return places.length === 0 ? null : { ...layout, novae: [...layout.novae, places[random.below(places.length)]] };
}

function freeNova(layout: Layout, spec: GeneratorSpec, free: readonly Way[], nova: Disc): Disc | null {
  if (!fits(layout, spec, nova, undefined, NOVA_MARGIN)) return null;
  return distanceToWays(free, nova) >= nova.radius + boxOf(rulesOf(layout)).halfDiagonal + spec.room ? nova : null;
}

/** A random place within 100 px of a random place on a path, on each axis. */
function beside(way: Way, random: Random): Place {
  const at = way[random.below(way.length)];
  return { x: Math.round(at.x) + random.below(201) - 100, y: Math.round(at.y) + random.below(201) - 100 };
}

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
