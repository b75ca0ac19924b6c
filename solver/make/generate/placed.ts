import { type Disc, KINDS, type ListedKind, type ObjectList, type Place, type Rules } from '../../../schema/basics/index.ts';

/** An object as in a level file, with numbers as its only fields. */
export type PlacedObject = Disc & Readonly<Record<string, number>>;

/** What a kind needs to know to place an object. */
interface Ground {
  /** A random whole number in [least, most]. */
  between(least: number, most: number): number;
  /** A random place near an asteroid, where she may pass. */
  inPlay(): Place;
  /** Whether a disc lies within the level and keeps its distance from the start. */
  isClear(disc: Disc): boolean;
  /** Whether it also keeps its distance, `gap` px, from all objects that are drawn solid. */
  isFree(disc: Disc, gap?: number): boolean;
  /** Where she starts. */
  readonly start: Place;
  readonly rules: Rules;
  /** The objects of the same kind placed so far. */
  readonly others: readonly PlacedObject[];
}

/** A kind of object that a level may get near its asteroids. */
interface PlacedKind {
  readonly kind: ListedKind;
  /** The name of its list in a level file, by which it is requested. */
  readonly list: ObjectList;
  /** Whether levels may have it unless told otherwise; others get it only on request, and then more often. */
  readonly isUsual: boolean;
  /** Whether other objects keep their distance from it. Objects that are not solid may lie over others. */
  readonly isSolid: boolean;
  /** Its turn when idle objects are removed; novae have turn 2, asteroids 3. */
  readonly turn: number;
  /** Tries to make one object; null when it does not fit. */
  make(ground: Ground): PlacedObject | null;
}

/** px between two objects of one kind, at least. */
const APART = 12;

/** Distance between two places, px. */
function distance(a: Place, b: Place): number {
  const [dx, dy] = [a.x - b.x, a.y - b.y];
  return Math.sqrt(dx * dx + dy * dy);
}

const repulsor = {
  kind: 'repulsor',
  list: 'repulsors',
  isUsual: true,
  isSolid: true,
  turn: 1,
  make({ between, inPlay, isFree }) {
    const field = { ...inPlay(), radius: between(0, 1) === 0 ? 32 : 48 };
    return isFree(field) ? field : null;
  },
} as const satisfies PlacedKind;

/** px between an alien and all other objects, at least. */
const ROOM = 40;

/** The radius that every alien gets, px: the usual one. */
export const ALIEN = KINDS.alien.fields.radius.default as number;

/** It sleeps when she starts. */
const alien = {
  kind: 'alien',
  list: 'aliens',
  isUsual: true,
  isSolid: true,
  turn: 0,
  make({ inPlay, isFree, start, rules }) {
    const made = { ...inPlay(), radius: ALIEN };
    return distance(made, start) >= rules.alienSight + ALIEN && isFree(made, ROOM) ? made : null;
  },
} as const satisfies PlacedKind;

/** px between the centres of both mouths, at least. */
const MOUTHS_APART = 160;

/** Both mouths lie where she may pass, and keep their distance from everything else. */
const wormhole = {
  kind: 'wormhole',
  list: 'wormholes',
  isUsual: false,
  isSolid: true,
  turn: 4,
  make({ between, inPlay, isFree }) {
    const radius = between(0, 1) === 0 ? 24 : 32;
    const [mouth, other] = [inPlay(), inPlay()];
    if (distance(mouth, other) < MOUTHS_APART) return null;
    if (!isFree({ ...mouth, radius }) || !isFree({ ...other, radius })) return null;
    return { ...mouth, toX: other.x, toY: other.y, radius };
  },
} as const satisfies PlacedKind;

/**
 * The least strength of a wind, and the most on each axis, px/s². A wind stronger than the nearby gun would leave nothing to
 * steer.
 */
const BREEZE = 10;
const GUST = 24;

/** Winds may lie over other objects, but not over each other. */
const wind = {
  kind: 'wind',
  list: 'winds',
  isUsual: false,
  isSolid: false,
  turn: 5,
  make({ between, inPlay, isClear, others }) {
    const made = { ...inPlay(), radius: between(0, 1) === 0 ? 64 : 96, ax: between(-GUST, GUST), ay: between(-GUST, GUST) };
    if (distance({ x: made.ax, y: made.ay }, { x: 0, y: 0 }) < BREEZE || !isClear(made)) return null;
    return others.every((other) => distance(other, made) >= other.radius + made.radius + APART) ? made : null;
  },
} as const satisfies PlacedKind;

/**
 * The kinds of objects that a level may get near its asteroids, in the order in which they are placed. Add new kinds at the end,
 * so that existing seeds keep their levels.
 */
export const PLACED_KINDS = [repulsor, alien, wormhole, wind] as const;

/** The lists of these kinds in a level file. */
export type PlacedList = (typeof PLACED_KINDS)[number]['list'];
