import {
  appearanceOfObject,
  isVariant,
  KINDS,
  type Level,
  LIMITS,
  LISTED_KINDS,
  type ListedKind,
  objectsIn,
} from '../../../schema/basics/index.ts';
import { type Change, type ObjectRef, objectAt, type Vector } from './change.ts';

/** Changes of one thing that differ in direction and size only. */
export interface Family {
  /** What they do and to which kind of object: proposals of the same group are of the same kind. */
  readonly group: string;
  /** The object; null for the range. */
  readonly object: ObjectRef | null;
  /** Whether a change has a direction in the plane, or only a sign. */
  readonly isPlane: boolean;
  /**
   * The change by a vector.
   * @param by px or px/s; where there is only a sign, `y` has no meaning
   * @returns null when nothing would change, or the result would not be valid
   */
  make(by: Vector): Change | null;
}

/** Values are rounded to this part of a unit, as a designer would write them. */
const PARTS = 10;

const rounded = (value: number): number => Math.round(value * PARTS) / PARTS;

/** A value that is not changed keeps all its digits. */
const changed = (value: number, by: number): number => (by === 0 ? value : rounded(value + by));

function changedBoth(from: Vector, by: Vector, most: number): Vector | null {
  const to = { x: changed(from.x, by.x), y: changed(from.y, by.y) };
  const isSame = to.x === from.x && to.y === from.y;
  return isSame || !(Math.abs(to.x) <= most && Math.abs(to.y) <= most) ? null : to;
}

function changedSize(from: number, by: number): number | null {
  const to = changed(from, by);
  return to === from || !(to >= 1 / PARTS && to <= LIMITS.radius) ? null : to;
}

/** All places where an object could stand. */
export function moveFamily(level: Level, object: ObjectRef): Family {
  const { x, y } = objectAt(level, object);
  const from = { x, y };
  return {
    group: `move ${object.kind}`,
    object,
    isPlane: true,
    make(by) {
      const to = changedBoth(from, by, LIMITS.coordinate);
      return to === null ? null : { what: 'move', object, from, to };
    },
  };
}

/** All radii that an object could have. */
export function resizeFamily(level: Level, object: ObjectRef): Family {
  const from = objectAt(level, object).radius;
  return {
    group: `resize ${object.kind}`,
    object,
    isPlane: false,
    make(by) {
      const to = changedSize(from, by.x);
      return to === null ? null : { what: 'resize', object, from, to };
    },
  };
}

/** All ranges that the level could have. */
export function rangeFamily({ range }: Level): Family {
  return {
    group: 'range',
    object: null,
    isPlane: false,
    make(by) {
      const to = changedSize(range, by.x);
      return to === null ? null : { what: 'range', from: range, to };
    },
  };
}

/** All velocities with which she could start. */
export function velocityFamily({ astronaut }: Level): Family {
  const from = { x: astronaut.vx, y: astronaut.vy };
  return {
    group: 'velocity',
    object: { kind: 'astronaut', index: 0 },
    isPlane: true,
    make(by) {
      const to = changedBoth(from, by, LIMITS.velocity);
      return to === null ? null : { what: 'velocity', from, to };
    },
  };
}

/** The group of a change. */
export const groupOf = (change: Change): string =>
  change.what === 'range' || change.what === 'velocity' ? change.what : `${change.what} ${change.object.kind}`;

/** The removal of an object. */
export const dropOf = (level: Level, object: ObjectRef): Change => ({
  what: 'drop',
  object,
  radius: objectAt(level, object).radius,
});

/** Whether an object has a radius that matters to a run. The radius of a cold asteroid matters only with recoil. */
export function hasRadius(level: Level, object: ObjectRef): boolean {
  const { kind } = object;
  return KINDS[kind].radius !== null && (kind !== 'asteroid' || level.recoil || isVariant(kind, objectAt(level, object)));
}

/** The objects that pull, push or carry her: where they stand decides how she flies. */
export const movers = (level: Level): ObjectRef[] =>
  LISTED_KINDS.filter((kind) => !KINDS[kind].deadly && kind !== 'mineral').flatMap((kind) => refsOf(level, kind));

/** The objects that end a run when she touches them: those of deadly kinds, then the deadly ones of other kinds. */
export const hazards = (level: Level): ObjectRef[] => [
  ...LISTED_KINDS.filter((kind) => KINDS[kind].deadly).flatMap((kind) => refsOf(level, kind)),
  ...LISTED_KINDS.filter((kind) => !KINDS[kind].deadly).flatMap((kind) =>
    refsOf(level, kind).filter((object) => appearanceOfObject(kind, objectAt(level, object)).deadly),
  ),
];

const refsOf = (level: Level, kind: ListedKind): ObjectRef[] => objectsIn(level, kind).map((_, index) => ({ kind, index }));

/** Whether two references lead to the same object. */
export const isSame = (a: ObjectRef, b: ObjectRef): boolean => a.kind === b.kind && a.index === b.index;

/** Her start. */
export const START: ObjectRef = { kind: 'astronaut', index: 0 };
/** The black hole. */
export const HOLE: ObjectRef = { kind: 'blackHole', index: 0 };
