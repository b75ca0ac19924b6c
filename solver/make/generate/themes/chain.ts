import type { Place } from '../../../../schema/basics/index.ts';
import { distance } from '../layout.ts';
import { takesOver } from '../takes-over.ts';
import type { Site } from './site.ts';

/** How the asteroids of a chain lie. Lengths are in px. */
export interface Chain {
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
