import { add, type Dd, dd, length, multiply, negate, subtract, toNumber, type Vector, ZERO } from './double-double.ts';
import type { World } from './world.ts';

/** The reference does not know how to go on: the caller leaves the scene out, and says so. */
export class NotCovered extends Error {}

/** Counts work. @throws NotCovered when more is done than is allowed */
export function spend(world: World, work: number): void {
  world.left -= work;
  if (world.left < 0) throw new NotCovered('too much happens');
}

/** What may happen; those that come first at the same instant stand first. */
export const KINDS = [
  ...(['mineral', 'nova', 'asteroid', 'alien', 'blackHole', 'range', 'jump'] as const),
  ...(['mouth', 'centre', 'target', 'field', 'wind', 'sight', 'explosion', 'limit', 'slip'] as const),
];
export type Kind = (typeof KINDS)[number];

export interface Happening {
  /** When, in the stretch's variable. */
  readonly at: Dd;
  readonly kind: Kind;
  /** Of the object in its list; of a mouth twice the wormhole's, plus 1 for its second one; of an axis 0 or 1. */
  readonly index: number;
  /** The other alien of an explosion. */
  readonly other: number;
}

/** How narrowly something did not happen. */
export interface Margins {
  /** The smallest that is not 0, px (of a speed px/s). */
  narrowest: number;
  /** How often something was decided by exactly 0. */
  exact: number;
}

/** Happenings that are as close as this are told, so that the caller sees that their order is narrow, s. */
export const CLOSE = 2e-9;

/** A margin below this is 0, px. */
export const EXACT = 1e-20;

/** Her state at a moment. */
export interface Body {
  readonly at: Vector;
  readonly velocity: Vector;
  /** The direction of the x axis of her box. */
  readonly box: Vector;
}

/** The motion of all from now on, as a method has computed it, until something happens or the method must begin anew. */
export interface Stretch {
  /** How long one unit of the stretch's variable is, s. */
  readonly unit: number;
  /** Up to which value of its variable it holds. */
  readonly reach: number;
  /** Her distance from the nearest centre of a force that is not on her line, px. */
  readonly besideCentre: number;
  /** What happens first in the stretch up to `end`, and what else follows within {@link CLOSE}. */
  happenings(end: Dd, margins: Margins): Happening[];
  bodyAt(s: Dd): Body;
  /** Moves the world on, but not its time. */
  moveTo(s: Dd): void;
}

/** A way to compute motion and to locate what happens. */
export type Method = (world: World) => Stretch;

/** The gap between her box, as it stands, and a circle, px; below 0 if they overlap, and 0 if they touch exactly. */
export function gapTo({ her, box, rules }: World, centre: Vector, radius: number): number {
  const gap = toNumber(gapBetween({ at: her.at, box }, rules, centre, radius));
  return Math.abs(gap) < 1e-24 * radius ? 0 : gap;
}

/** The gap between her box and a circle, px: from the circle's rim to the box, below 0 if they overlap. */
export function gapBetween(
  { at, box }: Pick<Body, 'at' | 'box'>,
  { boxWidth, boxHeight }: World['rules'],
  centre: Vector,
  radius: number,
): Dd {
  const dx = subtract(centre.x, at.x);
  const dy = subtract(centre.y, at.y);
  const x = add(multiply(dx, box.x), multiply(dy, box.y));
  const y = subtract(multiply(dy, box.x), multiply(dx, box.y));
  const beyond = (value: Dd, half: number): Dd => {
    const over = add(value.hi < 0 ? negate(value) : value, dd(-half));
    return over.hi > 0 ? over : ZERO;
  };
  return subtract(length({ x: beyond(x, boxWidth / 2), y: beyond(y, boxHeight / 2) }), dd(radius));
}
