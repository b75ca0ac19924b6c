import { boxOf } from '../../../engine/index.ts';
import { type Disc, type OwnRules, type Place, placesIn, rulesOf } from '../../../schema/basics/index.ts';
import type { Random } from '../../random.ts';
import type { GeneratorSpec } from './generator-spec.ts';
import { PLACED_KINDS, type PlacedList, type PlacedObject } from './placed.ts';

/** A level under construction. All coordinates are whole px. */
export interface Layout {
  readonly start: Place & { readonly vx: number; readonly vy: number };
  readonly blackHole: Disc;
  readonly recoil: boolean;
  readonly rules: OwnRules;
  readonly asteroids: readonly (Disc & { readonly hot: boolean })[];
  readonly novae: readonly Disc[];
  readonly minerals: readonly Disc[];
  /** Objects of the kinds that are placed near asteroids. */
  readonly placed: Readonly<Record<PlacedList, readonly PlacedObject[]>>;
}

/** px between two objects; closer ones look like one. */
const GAP = 12;

/** px between any object but a nova and the edge of the level: room for her to pass. */
const MARGIN = 50;

/** px between a nova and the edge of the level, at least: a nova may close the way along the edge. */
export const NOVA_MARGIN = 22;

/** px around the start that stay free, at least, and px around her box: nobody should die before the first press. */
const START_FREE = 75;
const BOX_FREE = 20;

/** The largest initial speed on each axis, px/s. */
const START_SPEED = 50;

const TRIES = 60;

/** Distance between two places, px. */
export const distance = (a: Place, b: Place): number => {
  const dx = a.x - b.x;
  const dy = a.y - b.y;
  return Math.sqrt(dx * dx + dy * dy);
};

/** All objects that are drawn solid, or whose rims should be visible as a whole. */
export function bodiesOf({ blackHole, asteroids, novae, placed }: Layout): Disc[] {
  const solid = PLACED_KINDS.filter(({ isSolid }) => isSolid).flatMap(({ kind, list }) =>
    placed[list].flatMap((object) => placesIn(kind, object).map(({ x, y }) => ({ x, y, radius: object.radius }))),
  );
  return [blackHole, ...asteroids, ...novae, ...solid];
}

/** Whether a disc lies within the margins and keeps its distance from all other objects and from the start. */
export function fits(layout: Layout, spec: GeneratorSpec, disc: Disc, gap = GAP, margin = MARGIN): boolean {
  if (!isClear(layout, spec, disc, margin)) return false;
  return bodiesOf(layout).every((other) => distance(other, disc) >= other.radius + disc.radius + gap);
}

/** Whether a disc lies within the margins and keeps its distance from the start. */
function isClear(layout: Layout, spec: GeneratorSpec, { x, y, radius }: Disc, margin = MARGIN): boolean {
  if (x < margin + radius || y < margin + radius) return false;
  if (x > spec.width - margin - radius || y > spec.height - margin - radius) return false;
  const free = Math.max(START_FREE, boxOf(rulesOf(layout)).halfDiagonal + BOX_FREE);
  return distance({ x, y }, layout.start) >= free + radius;
}

/**
 * Lays out a chain of asteroids, each in range of the one before, and other ingredients near them. The black hole, novae and minerals are added later, when her path is known.
 * @returns null when the chain did not fit
 */
export function layOut(random: Random, spec: GeneratorSpec): Layout | null {
  const between = (least: number, most: number) => least + random.below(most - least + 1);
  const near = (around: Place, least: number, most: number): Place => {
    for (;;) {
      const place = { x: between(-most, most), y: between(-most, most) };
      const d = distance(place, { x: 0, y: 0 });
      if (d >= least && d <= most) return { x: around.x + place.x, y: around.y + place.y };
    }
  };
  // One level in three begins with a moving astronaut.
  const speed = random.below(3) === 0 ? START_SPEED : 0;
  const start = {
    x: between(MARGIN + 30, spec.width - MARGIN - 30),
    y: between(MARGIN + 30, spec.height - MARGIN - 30),
    vx: between(-speed, speed),
    vy: between(-speed, speed),
  };
  const recoil = spec.ingredients.includes('recoil') && random.below(2) === 0;
  let layout: Layout = { ...emptyLayout(spec), start, recoil };

  const count = between(...spec.asteroids);
  let last: Place = start;
  for (let i = 0; i < count; i++) {
    const radius = random.below(2) === 0 ? 16 : 32;
    const hot = i > 0 && spec.ingredients.includes('hot') && random.below(5) === 0;
    const place = tryOften(() => {
      const disc = { ...(i === 0 ? near(start, 100, 190) : near(last, 160, 270)), radius };
      const apart = layout.asteroids.every((other) => distance(other, disc) >= 140);
      // from rest she falls along a line, and leaves it only where another asteroid takes over
      const leads = speed > 0 || i !== 1 || takesOver(start, last, disc);
      return apart && leads && fits(layout, spec, disc) ? disc : null;
    });
    if (place === null) return null;
    layout = { ...layout, asteroids: [...layout.asteroids, { ...place, hot }] };
    last = place;
  }

  // A place near an asteroid, where she may pass. Objects out of every asteroid's range would be mere decoration.
  const inPlay = (): Place => near(layout.asteroids[random.below(layout.asteroids.length)], 50, 190);
  for (const { list, isUsual, make } of PLACED_KINDS) {
    // What is placed only on request should appear more often.
    const isThere = spec.ingredients.includes(list) && random.below(3) < (isUsual ? 1 : 2);
    for (let n = isThere ? between(1, Math.max(1, Math.round(count / 2))) : 0; n > 0; n--) {
      const there = layout;
      const ground = {
        between,
        inPlay,
        isClear: (disc: Disc) => isClear(there, spec, disc),
        isFree: (disc: Disc, gap?: number) => fits(there, spec, disc, gap),
        start,
        rules: rulesOf(spec),
        others: there.placed[list],
      };
      const object = tryOften((): PlacedObject | null => make(ground));
      if (object !== null) layout = withPlaced(layout, list, object);
    }
  }
  return layout;
}

/** The layout with one more object of a kind. */
export const withPlaced = (layout: Layout, list: PlacedList, object: PlacedObject): Layout => ({
  ...layout,
  placed: { ...layout.placed, [list]: [...layout.placed[list], object] },
});

/** A level without objects, with the start at the origin and the black hole out of reach. */
export const emptyLayout = (spec: GeneratorSpec): Layout => ({
  start: { x: 0, y: 0, vx: 0, vy: 0 },
  blackHole: FAR_AWAY,
  rules: spec.rules,
  recoil: false,
  asteroids: [],
  novae: [],
  minerals: [],
  placed: Object.fromEntries(PLACED_KINDS.map(({ list }) => [list, []])) as unknown as Layout['placed'],
});

// Placeholder for the black hole before it is placed, where nobody can reach it.
const FAR_AWAY: Disc = { x: 1e6, y: 1e6, radius: 18 };

/** The first result of many tries. */
export function tryOften<T>(attempt: () => T | null): T | null {
  for (let i = 0; i < TRIES; i++) {
    const result = attempt();
    if (result !== null) return result;
  }
  return null;
}

// Of the distance that she has fallen.
const TAKEN = 0.9;

/** Whether she comes nearer to the second asteroid than to the first, when she falls from rest through the first and beyond it. */
export function takesOver(start: Place, first: Place, second: Place): boolean {
  const [ahead, down] = [first.x - start.x, first.y - start.y];
  const fall = Math.sqrt(ahead * ahead + down * down);
  const [dx, dy] = [second.x - first.x, second.y - first.y];
  const along = (dx * ahead + dy * down) / fall;
  // the places that are as far from both lie on a line across; she meets it so far beyond the first
  return along > 0 && (dx * dx + dy * dy) / (2 * along) < TAKEN * fall;
}
