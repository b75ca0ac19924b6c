import { boxOf } from '../../../../engine/index.ts';
import { type Disc, type Place, rulesOf } from '../../../../schema/basics/index.ts';
import type { Random } from '../../../random.ts';
import type { GeneratorSpec } from '../generator-spec.ts';
import { distance, emptyLayout, fits, type Layout, NOVA_MARGIN, takesOver, tryOften, withPlaced } from '../layout.ts';
import type { PlacedList } from '../placed.ts';
import { distanceToWays, type Way } from '../tube.ts';

/** px of the grid on which themes place asteroids and fields, and of the finer one for novae that follow no curve. */
export const COARSE = 8;
export const FINE = 4;

/** The place of a grid that is nearest to a place. */
export const snap = ({ x, y }: Place, grid: number): Place => ({
  x: Math.round(x / grid) * grid,
  y: Math.round(y / grid) * grid,
});

// px around the start that stay free, and between it and the edge, at least.
const START_FREE = 75;
const START_MARGIN = 60;

const FAR = { x: -1e4, y: -1e4, vx: 0, vy: 0 };

// px between the centres of two asteroids, at least.
const ASTEROIDS_APART = 130;

/** A level while a theme composes it. What does not fit is left out, and what would close a way that must stay open. */
export class Site {
  readonly spec: GeneratorSpec;
  readonly random: Random;
  layout: Layout;
  /** Ways that novae must leave open. */
  readonly free: readonly Way[];
  /** Places that continue the composition, for novae that make the level harder. */
  readonly slots: Disc[] = [];
  /** Objects that stay although no game may touch them, because something else needs them to be seen. */
  readonly kept: Disc[] = [];

  constructor(spec: GeneratorSpec, random: Random, layout: Layout = emptyLayout(spec), free: readonly Way[] = []) {
    this.spec = spec;
    this.random = random;
    this.layout = layout;
    this.free = free;
  }

  /** A random whole number in [least, most]. */
  between(least: number, most: number): number {
    return least + this.random.below(Math.max(0, Math.round(most) - least) + 1);
  }

  /** Whether the level may contain an ingredient, and one draw of `n` is 0. */
  mayContain(ingredient: GeneratorSpec['ingredients'][number], n: number): boolean {
    return this.spec.ingredients.includes(ingredient) && this.random.below(n) === 0;
  }

  /** A random place of the coarse grid, at a distance of [least, most] px from another. */
  near(around: Place, least: number, most: number): Place {
    for (;;) {
      const place = { x: this.between(0, 2 * most) - most, y: this.between(0, 2 * most) - most };
      const away = distance(place, { x: 0, y: 0 });
      if (away >= least && away <= most) return snap({ x: around.x + place.x, y: around.y + place.y }, COARSE);
    }
  }

  /** Whether she may start at a place: within the margins and clear of everything that is there. */
  takesStart(place: Place): boolean {
    return fits({ ...this.layout, start: FAR }, this.spec, { ...place, radius: 0 }, START_FREE, START_MARGIN);
  }

  start(place: Place, vx = 0, vy = 0): void {
    this.layout = { ...this.layout, start: { ...snap(place, COARSE), vx, vy } };
  }

  /** Tries to place an asteroid at one of the places that `find` draws. */
  asteroid(find: () => Place, radius: number, hot = false): Place | null {
    const found = tryOften(() => {
      const disc = { ...snap(find(), COARSE), radius };
      const apart = this.layout.asteroids.every((other) => distance(other, disc) >= ASTEROIDS_APART);
      return apart && fits(this.layout, this.spec, disc) ? disc : null;
    });
    if (found !== null) this.layout = { ...this.layout, asteroids: [...this.layout.asteroids, { ...found, hot }] };
    return found;
  }

  /** Places an object of a kind, if it fits. */
  object(list: PlacedList, disc: Disc): void {
    if (fits(this.layout, this.spec, disc)) this.layout = withPlaced(this.layout, list, { ...disc });
  }

  /** Whether a nova fits and leaves all ways open with so much room beyond her box, px. */
  takesNova(disc: Disc, room: number = this.spec.room): boolean {
    if (!fits(this.layout, this.spec, disc, undefined, NOVA_MARGIN)) return false;
    if (this.layout.minerals.some((mineral) => distance(mineral, disc) < mineral.radius + disc.radius + FINE)) return false;
    return distanceToWays(this.free, disc) >= disc.radius + boxOf(rulesOf(this.layout)).halfDiagonal + room;
  }

  /**
   * Places a nova, at whole px.
   * @returns the nova; null where it does not fit
   */
  nova({ x, y }: Place, radius: number): Disc | null {
    const disc = { x: Math.round(x), y: Math.round(y), radius };
    if (!this.takesNova(disc)) return null;
    this.layout = { ...this.layout, novae: [...this.layout.novae, disc] };
    return disc;
  }

  /** Keeps an object, if there is one, even if it turns out to be idle. */
  keep(object: Disc | null): void {
    if (object !== null) this.kept.push(object);
  }

  /** Offers a place for a nova. */
  slot({ x, y }: Place, radius: number): void {
    this.slots.push({ x: Math.round(x), y: Math.round(y), radius });
  }
}

/** How the asteroids of a chain lie. Lengths are in px. */
interface Chain {
  /** Distance of the first one from the start. */
  readonly first: readonly [least: number, most: number];
  /** Distance of each other one from the one before. */
  readonly next: readonly [least: number, most: number];
  /** Radii: of the first one, and of each other one. */
  readonly radii: readonly [first: number, next: () => number];
}

// Her speed at the start where she moves, px/s: about that of a circle around the first asteroid.
const SLOWEST = 28;
const FASTEST = 56;

/**
 * Places up to `count` asteroids one after the other. One time in two she starts moving across the line to the first one. Otherwise
 * she falls along that line, so the second one lies where it becomes the nearest before she has fallen as far again as she came.
 * @returns whether there are at least two
 */
export function placeChain(site: Site, count: number, { first, next, radii }: Chain): boolean {
  const { start } = site.layout;
  const begin = site.asteroid(() => site.near(start, ...first), radii[0]);
  if (begin === null) return false;
  const isMoving = site.random.below(2) === 0;
  if (isMoving) setOff(site, begin);
  let last = begin;
  for (let i = 1; i < count; i++) {
    const isReached = (place: Place) => isMoving || i > 1 || takesOver(start, begin, place);
    const found = site.asteroid(() => drawUntil(() => site.near(last, ...next), isReached), radii[1]());
    if (found === null) break;
    last = found;
  }
  return site.layout.asteroids.length >= 2;
}

/** She starts across the line to an asteroid. */
export function setOff(site: Site, to: Place): void {
  const { start } = site.layout;
  const away = distance(start, to);
  const speed = (site.random.below(2) === 0 ? 1 : -1) * site.between(SLOWEST, FASTEST);
  site.start(start, Math.round((-(start.y - to.y) / away) * speed), Math.round(((start.x - to.x) / away) * speed));
}

const DRAWS = 40;

function drawUntil(draw: () => Place, suits: (place: Place) => boolean): Place {
  let place = draw();
  for (let i = 1; i < DRAWS && !suits(place); i++) place = draw();
  return place;
}
