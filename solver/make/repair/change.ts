import { KINDS, type Level, type ObjectKind } from '../../../schema/basics/index.ts';

/** A reference to an object of a level. */
export interface ObjectRef {
  /** The kind of the object. */
  readonly kind: ObjectKind;
  /** Index in the level's list of that kind, from 0; 0 for the astronaut and the black hole. */
  readonly index: number;
}

/** A place or a velocity, px or px/s. */
export interface Vector {
  /** To the right. */
  readonly x: number;
  /** Downwards. */
  readonly y: number;
}

/** One change of one thing in a level. `what` tells the kinds apart. */
export type Change =
  | {
      /** The object stands somewhere else. Of two places that it has, the first one changes. */
      readonly what: 'move';
      /** What is moved; the astronaut is her start. */
      readonly object: ObjectRef;
      /** Where it stands in the level, px. */
      readonly from: Vector;
      /** Where it stands after the change, px. */
      readonly to: Vector;
    }
  | {
      /** The object has another radius. */
      readonly what: 'resize';
      /** What has another radius. */
      readonly object: ObjectRef;
      /** Its radius in the level, px. */
      readonly from: number;
      /** Its radius after the change, px. */
      readonly to: number;
    }
  | {
      /** The object is removed. */
      readonly what: 'drop';
      /** What is removed. */
      readonly object: ObjectRef;
      /** Its radius, px. */
      readonly radius: number;
    }
  | {
      /** The level has another range. */
      readonly what: 'range';
      /** The level's range, px. */
      readonly from: number;
      /** The range after the change, px. */
      readonly to: number;
    }
  | {
      /** She starts with another velocity. */
      readonly what: 'velocity';
      /** Her velocity at the start, px/s. */
      readonly from: Vector;
      /** Her velocity at the start after the change, px/s. */
      readonly to: Vector;
    };

/** One edit of a level, or of its file: both have the same keys where an edit leads. */
export interface LevelEdit {
  /** Keys and indices that lead to the value, such as `['novae', 3, 'x']`. */
  readonly path: readonly (string | number)[];
  /** The new number; null removes the entry of a list. */
  readonly value: number | null;
}

/** Velocity counts as the way that it takes her in the first second. */
const distance = (a: Vector, b: Vector): number => Math.sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));

/**
 * The size of a change, by one measure for all kinds.
 * @param change the change
 * @returns px: how far an object is moved; by how much a radius or the range differs; for a velocity, how far she is from
 * where she would be after one second without forces; for an object that is removed, its diameter
 */
export function changeSize(change: Change): number {
  switch (change.what) {
    case 'move':
    case 'velocity':
      return distance(change.from, change.to);
    case 'resize':
    case 'range':
      return Math.abs(change.to - change.from);
    case 'drop':
      return 2 * change.radius;
  }
}

/**
 * The edits that a change consists of.
 * @param change the change
 * @returns one or two edits
 */
export function changeEdits(change: Change): LevelEdit[] {
  switch (change.what) {
    case 'move':
      return pair(pathTo(change.object), ['x', 'y'], change.from, change.to);
    case 'velocity':
      return pair(['astronaut'], ['vx', 'vy'], change.from, change.to);
    case 'resize':
      return [{ path: [...pathTo(change.object), 'radius'], value: change.to }];
    case 'range':
      return [{ path: ['range'], value: change.to }];
    case 'drop':
      return [{ path: pathTo(change.object), value: null }];
  }
}

function pair(path: readonly (string | number)[], [x, y]: readonly [string, string], from: Vector, to: Vector): LevelEdit[] {
  const edits: LevelEdit[] = [];
  if (to.x !== from.x) edits.push({ path: [...path, x], value: to.x });
  if (to.y !== from.y) edits.push({ path: [...path, y], value: to.y });
  return edits;
}

function pathTo({ kind, index }: ObjectRef): readonly (string | number)[] {
  const { list } = KINDS[kind];
  return list === null ? [kind] : [list, index];
}

/**
 * Makes a changed copy of a level, or of the content of its file. What a change does not concern is kept.
 * @param whole the level, or the content of a level file
 * @param change the change
 * @returns the copy
 */
export function applyChange<T extends object>(whole: T, change: Change): T {
  return changeEdits(change).reduce<unknown>((value, { path, value: to }) => edited(value, path, to), whole) as T;
}

function edited(value: unknown, [key, ...rest]: readonly (string | number)[], to: number | null): unknown {
  if (Array.isArray(value)) {
    const entries: unknown[] = [...value];
    const index = key as number;
    if (rest.length === 0 && to === null) entries.splice(index, 1);
    else entries[index] = edited(entries[index], rest, to);
    return entries;
  }
  const object = value as Readonly<Record<string, unknown>>;
  return { ...object, [key]: rest.length === 0 ? to : edited(object[key], rest, to) };
}

/** The object that a reference leads to. */
export function objectAt(level: Level, { kind, index }: ObjectRef): Readonly<Record<'x' | 'y' | 'radius', number>> {
  const found = (level as unknown as Readonly<Record<string, unknown>>)[KINDS[kind].list ?? kind];
  return (KINDS[kind].list === null ? found : (found as readonly unknown[])[index]) as never;
}
