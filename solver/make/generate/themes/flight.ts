import { type Scene, STATE_SIZE, simulate, TICK } from '../../../../engine/index.ts';
import type { Disc, Hold, Place } from '../../../../schema/basics/index.ts';
import { distance } from '../layout.ts';
import { directionOf, stepsBetween, TURN } from './directions.ts';

/** A run as it looks in a picture: her centre and the gun, sampled at even times. */
export interface Flight {
  readonly places: readonly Place[];
  /** Whether the gun is held there. */
  readonly held: readonly boolean[];
}

/** Ticks between two places of a flight. */
export const EVERY = 3;

/** The flight of a run up to its end. */
export function flightOf(scene: Scene, holds: readonly Hold[]): Flight {
  const run = simulate(scene, holds);
  const state = new Float64Array(STATE_SIZE);
  const places: Place[] = [];
  const held: boolean[] = [];
  for (let tick = 0; tick * TICK < run.time; tick += EVERY) {
    run.trajectory.at(tick * TICK, state);
    places.push({ x: state[0], y: state[1] });
    held.push(holds.some(([press, release]) => tick >= press && tick < release));
  }
  return { places, held };
}

/** The length of a path, px. */
export function lengthOf(places: readonly Place[]): number {
  let sum = 0;
  for (let i = 1; i < places.length; i++) sum += distance(places[i - 1], places[i]);
  return sum;
}

/** How far she turns around an asteroid at most while it is the nearest one, in full turns; and which one that is. */
export function longestOrbit(asteroids: readonly Disc[], { places }: Flight): { readonly turns: number; readonly index: number } {
  let [best, index] = [0, 0];
  let nearest = -1;
  let [swept, direction] = [0, 0];
  for (const place of places) {
    let [next, least] = [0, Number.POSITIVE_INFINITY];
    for (const [i, asteroid] of asteroids.entries()) {
      const away = distance(asteroid, place);
      if (away < least) [next, least] = [i, away];
    }
    const now = directionOf(place.x - asteroids[next].x, place.y - asteroids[next].y);
    swept = next === nearest ? swept + stepsBetween(direction, now) : 0;
    [nearest, direction] = [next, now];
    if (Math.abs(swept) > best) [best, index] = [Math.abs(swept), next];
  }
  return { turns: best / TURN, index };
}

/** Stretches of a flight on which the gun is not held, as indices of its first and its last place. */
export function coastsOf({ places, held }: Flight): (readonly [first: number, last: number])[] {
  const coasts: [number, number][] = [];
  for (let i = 0; i < places.length; i++) {
    if (held[i]) continue;
    if (i > 0 && !held[i - 1]) coasts[coasts.length - 1][1] = i;
    else coasts.push([i, i]);
  }
  return coasts;
}

/** The unit vector along a path at one of its places; null where she rests. */
export function headingAt(places: readonly Place[], i: number): Place | null {
  const [a, b] = [places[Math.max(0, i - 1)], places[Math.min(places.length - 1, i + 1)]];
  const length = distance(a, b);
  return length < 0.5 ? null : { x: (b.x - a.x) / length, y: (b.y - a.y) / length };
}
