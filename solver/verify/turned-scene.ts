import { TICK } from '../../engine/index.ts';
import type { Direction } from '../proofs/index.ts';
import { driftIn } from './assumptions.ts';
import type { Claim } from './claim.ts';
import { mouthsOf } from './mouths.ts';
import type { Point } from './rounded.ts';

/** A circle, px from the start along the axes of a certificate. */
export type Circle = Point & { readonly radius: number };

/** A disc in which a steady acceleration is added to all others, px/s2 along the axes of a certificate. */
export interface Wind extends Circle {
  readonly ax: number;
  readonly ay: number;
}

/** A level as it lies to the axes that a certificate names; places in px from the start. */
export interface TurnedScene {
  readonly thing: Point;
  /** hers at the start, px/s */
  readonly velocity: Point;
  /** radius: the range */
  readonly asteroids: readonly Circle[];
  readonly fields: readonly Circle[];
  readonly winds: readonly Wind[];
  /** of wormholes */
  readonly mouths: readonly Circle[];
  /** from the level's axes to these */
  turn(p: Point): Point;
  /** how far recoil has carried an asteroid at most after so many seconds, px */
  drift(asteroid: number, seconds: number): number;
}

/** The level with a direction as x. */
export function turnedScene(claim: Claim, [ux, uy]: Direction): TurnedScene {
  const { level, rules, thing, place } = claim;
  const turn = ({ x, y }: Point): Point => ({ x: x * ux + y * uy, y: y * ux - x * uy });
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

/** Whether that is a unit vector: a certificate may say anything. */
export const isAxis = (axis: Direction | undefined): axis is Direction =>
  Array.isArray(axis) && axis.length === 2 && Math.abs(axis[0] * axis[0] + axis[1] * axis[1] - 1) < 1e-12;

/** Whether that is a number from the least to the most of two. */
export const isFrom = (least: number, most: number, n: unknown): n is number => typeof n === 'number' && n >= least && n <= most;

/** The same for whole numbers. */
export const isCount = (least: number, most: number, n: unknown): n is number => isFrom(least, most, n) && Number.isInteger(n);
