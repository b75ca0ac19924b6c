import { type Level, rulesOf } from '../../../schema/basics/index.ts';
import {
  type Dd,
  dd,
  dot,
  minus,
  NOWHERE,
  roughLength,
  subtract,
  times,
  twoSum,
  type Vector,
  vector,
  ZERO,
} from './double-double.ts';

/** Something that moves: a place, px, and a velocity, px/s. */
export interface Mover {
  at: Vector;
  velocity: Vector;
}

interface Alien extends Mover {
  awake: boolean;
  gone: boolean;
}

/** Lengths below this are 0, px: only what is exactly 0 is as small, up to the rounding of 32 digits. */
export const NO_LENGTH = 1e-20;

/** The state of a game at a moment. */
export interface World {
  readonly level: Level;
  readonly rules: ReturnType<typeof rulesOf>;
  /** Time since the start, s. */
  time: Dd;
  readonly her: Mover;
  /** The direction of the x axis of her box. */
  box: Vector;
  readonly asteroids: readonly Mover[];
  readonly aliens: readonly Alien[];
  held: boolean;
  /** The asteroid that the held gun pulls towards; -1 if there is none. */
  target: number;
  /** An asteroid in whose range she is. */
  anchor: number;
  /** Whether her centre is in each repulsor, and in each wind. */
  readonly fields: boolean[];
  readonly winds: boolean[];
  /** Of each wormhole, the mouth that she is in and that does not fire: 1 or 2; 0 for none. */
  readonly mouths: number[];
  /** The rim on which she slides; whether she counts as in it then means nothing. */
  slide: { readonly kind: 'field' | 'wind'; readonly index: number } | null;
  /** Whether a velocity component is at the speed limit and stays there: its sign, else 0. */
  readonly limits: [x: number, y: number];
  readonly taken: boolean[];
  /** Work that may still be done: about as many evaluations of a force or a guard. */
  left: number;
}

/** A small change of the start: px and px/s. */
export type Nudge = readonly [x: number, y: number, vx: number, vy: number];

/** The world at the start, before anything is decided. */
export function startOf(level: Level, nudge: Nudge): World {
  const { astronaut } = level;
  const rules = rulesOf(level);
  const limit = rules.speedLimit;
  // what is faster than the limit from the start is as fast as the limit
  const speed = (v: number, by: number): Dd => (Math.abs(v) >= limit ? dd(Math.sign(v) * limit) : twoSum(v, by));
  return {
    level,
    rules,
    time: ZERO,
    her: {
      at: { x: twoSum(astronaut.x, nudge[0]), y: twoSum(astronaut.y, nudge[1]) },
      velocity: { x: speed(astronaut.vx, nudge[2]), y: speed(astronaut.vy, nudge[3]) },
    },
    box: vector(1, 0),
    asteroids: level.asteroids.map((c) => ({ at: placeOf(c), velocity: NOWHERE })),
    aliens: level.aliens.map((c) => ({ at: placeOf(c), velocity: NOWHERE, awake: false, gone: false })),
    held: false,
    target: -1,
    anchor: -1,
    fields: level.repulsors.map(() => false),
    winds: level.winds.map(() => false),
    mouths: level.wormholes.map(() => 0),
    slide: null,
    limits: [0, 0],
    taken: level.minerals.map(() => false),
    left: Number.POSITIVE_INFINITY,
  };
}

/** The order in which equally near asteroids are preferred: cold ones first, then as in the level. */
export function byPreference({ asteroids }: Level): number[] {
  const all = [...asteroids.keys()];
  return [...all.filter((i) => !asteroids[i].hot), ...all.filter((i) => asteroids[i].hot)];
}

/**
 * Whether her centre is in a disc. On the very rim her direction decides if `moving`, else she is outside.
 */
export function isIn(world: World, centre: Vector, radius: number, moving: boolean): boolean {
  const u = minus(world.her.at, centre);
  const r2 = times(dd(radius), radius);
  const depth = subtract(r2, dot(u, u));
  if (Math.abs(depth.hi) > 1e-24 * r2.hi) return depth.hi > 0;
  return moving && dot(u, world.her.velocity).hi < 0;
}

/** The nearest asteroid; of those that are equally near the first. */
export const nearest = (world: World): number => nearestOf(world, () => false);

/** The same of those that become the nearest at one instant: of equally near ones that which comes nearer. */
export const nearer = (world: World): number =>
  nearestOf(world, (closing, than, speed) => subtract(closing, than).hi < -1e-22 * speed);

function nearestOf(world: World, isNearer: (closing: Dd, than: Dd, speed: number) => boolean): number {
  let best = -1;
  let least = ZERO;
  let approach = ZERO;
  for (const i of byPreference(world.level)) {
    const { at, velocity } = world.asteroids[i];
    const u = minus(at, world.her.at);
    const d2 = dot(u, u);
    const relative = minus(velocity, world.her.velocity);
    const closing = dot(u, relative);
    const gap = subtract(d2, least).hi;
    const same = Math.abs(gap) <= 1e-24 * (d2.hi + least.hi);
    const speed = roughLength(relative.x.hi, relative.y.hi) * Math.sqrt(d2.hi);
    if (best < 0 || (same ? isNearer(closing, approach, speed) : gap < 0)) {
      best = i;
      least = d2;
      approach = closing;
    }
  }
  return best;
}

const PLACES = new WeakMap<object, Vector>();

/** The place of an object of a level. */
export function placeOf(object: { readonly x: number; readonly y: number }): Vector {
  const known = PLACES.get(object);
  if (known !== undefined) return known;
  const place = vector(object.x, object.y);
  PLACES.set(object, place);
  return place;
}

const SECOND_MOUTHS = new WeakMap<object, Vector>();

/** The place of a wormhole's second mouth. */
export function secondMouth(wormhole: Level['wormholes'][number]): Vector {
  const known = SECOND_MOUTHS.get(wormhole);
  if (known !== undefined) return known;
  const place = vector(wormhole.toX, wormhole.toY);
  SECOND_MOUTHS.set(wormhole, place);
  return place;
}
