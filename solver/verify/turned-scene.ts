import { TICK } from '../../engine/index.ts';
import type { Disc, Place } from '../../schema/basics/index.ts';
import type { Direction } from '../prove/index.ts';
import { driftIn } from './assumptions.ts';
import { type Claim, mouthsOf } from './claim.ts';

/** A disc in which a constant acceleration is added to all others, px/s² along the axes of a certificate. */
export interface Wind extends Disc {
  readonly ax: number;
  readonly ay: number;
}

/** A level along the axes of a certificate; places are px from the start. */
export interface TurnedScene {
  readonly thing: Place;
  /** Her velocity at the start, px/s. */
  readonly velocity: Place;
  /** The asteroids; the radius is the range. */
  readonly asteroids: readonly Disc[];
  readonly fields: readonly Disc[];
  readonly winds: readonly Wind[];
  /** The mouths of wormholes. */
  readonly mouths: readonly Disc[];
  /** Converts from the level's axes to these. */
  turn(p: Place): Place;
  /** How far recoil can have carried an asteroid after so many seconds, px. */
  drift(asteroid: number, seconds: number): number;
}

/** The level with the given direction as its x axis. */
export function turnedScene(claim: Claim, [ux, uy]: Direction): TurnedScene {
  const { level, rules, thing, place } = claim;
  const turn = ({ x, y }: Place): Place => ({ x: x * ux + y * uy, y: y * ux - x * uy });
  return {
    thing: turn(thing),
    velocity: turn({ x: level.astronaut.vx, y: level.astronaut.vy }),
    asteroids: level.asteroids.map((a) => ({ ...turn(place(a)), radius: level.range })),
    fields: level.repulsors.map((field) => ({ ...turn(place(field)), radius: field.radius })),
    winds: level.winds.map((wind) => {
      const { x: ax, y: ay } = turn({ x: wind.ax, y: wind.ay });
      return { ...turn(place(wind)), radius: wind.radius, ax, ay };
    }),
    mouths: mouthsOf(claim).map((mouth) => ({ ...turn(mouth), radius: mouth.radius })),
    turn,
    drift: (i, seconds) => driftIn(level, rules, i, seconds * (seconds + TICK)),
  };
}

/** Whether a value is a unit vector; a certificate may contain anything. */
export const isAxis = (axis: Direction | undefined): axis is Direction =>
  Array.isArray(axis) && axis.length === 2 && Math.abs(axis[0] * axis[0] + axis[1] * axis[1] - 1) < 1e-12;

/** Whether a value is a number between two bounds. */
export const isFrom = (least: number, most: number, n: unknown): n is number => typeof n === 'number' && n >= least && n <= most;

/** Whether a value is a whole number between two bounds. */
export const isCount = (least: number, most: number, n: unknown): n is number => isFrom(least, most, n) && Number.isInteger(n);
