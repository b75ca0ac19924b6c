import { OBJECT_LISTS, type Path } from '../basics/index.ts';
import { isObject } from '../json/index.ts';
import type { Shape, ShapesByKey, ValueOf } from './shape.ts';

type Test = (value: unknown) => boolean;

/** The tests of the shapes that somebody has asked about. */
const tests = new WeakMap<Shape, Test>();

/**
 * Whether a JSON value has a shape: keys, types, limits. The functions that test this are made once, of the shape. Nearly every
 * file fits, so only the others are looked through for their faults, which takes several times as long.
 */
export function fits<S extends Shape>(value: unknown, shape: S): value is ValueOf<S> & typeof value {
  let test = tests.get(shape);
  if (test === undefined) {
    test = testOf(shape);
    tests.set(shape, test);
  }
  return test(value);
}

function testOf({ nullable, ...shape }: Shape): Test {
  const test = bareTestOf(shape);
  return nullable === true ? (value) => value === null || test(value) : test;
}

function bareTestOf({
  type,
  least = Number.NEGATIVE_INFINITY,
  most = Number.POSITIVE_INFINITY,
  only,
  among,
  pattern,
  each,
  keys,
}: Shape): Test {
  if (only !== undefined) return (value) => value === only;
  if (among !== undefined) return (value) => among.includes(value as string);
  switch (type) {
    case undefined:
      return () => true;
    case 'boolean':
      return (value) => value === true || value === false;
    case 'number':
      return (value) => typeof value === 'number' && value >= least && value <= most && Number.isFinite(value);
    case 'integer':
      return (value) => Number.isInteger(value) && (value as number) >= least && (value as number) <= most;
    case 'string': {
      const form = pattern === undefined ? null : new RegExp(pattern);
      return (value) =>
        typeof value === 'string' && value.length >= least && value.length <= most && (form === null || form.test(value));
    }
    case 'array': {
      const fits = testOf(each ?? {});
      return (value) => Array.isArray(value) && value.length >= least && value.length <= most && value.every(fits);
    }
    case 'object':
      return testOfObject(keys ?? {});
  }
}

function testOfObject(keys: ShapesByKey): Test {
  const tests = new Map(Object.entries(keys).map(([key, shape]) => [key, testOf(shape)]));
  const needed = Object.keys(keys).filter((key) => keys[key].optional !== true);
  return (value) => {
    if (!isObject(value)) return false;
    for (const key of Object.keys(value)) {
      const fits = tests.get(key);
      if (fits === undefined ? !isExtension(key) : !fits(value[key])) return false;
    }
    return needed.every((key) => Object.hasOwn(value, key));
  };
}

/** Whether a key of an object is free for anyone to use: such keys are kept and not checked. */
const isExtension = (key: string): boolean => key.startsWith('x-');

/** Where a value has another shape than it must have, without words. */
export interface Fault {
  readonly what: 'wrong-type' | 'other-value' | 'too-small' | 'too-big' | 'wrong-form' | 'unknown-key' | 'missing-key';
  /** Leads to the value, or to the key that is unknown or missing. */
  readonly path: Path;
  /** The value that is there; undefined for a missing key. */
  readonly value: unknown;
  /** What must be there; of an unknown key: the shape of the object. */
  readonly shape: Shape;
}

/** Whether a value has the type that its shape says. Entries and keys are not looked at. */
function isOfType({ type, only }: Shape, value: unknown): boolean {
  switch (type) {
    case 'array':
      return Array.isArray(value);
    case 'object':
      return isObject(value);
    case 'integer':
      return Number.isInteger(value);
    default:
      return type === undefined || only !== undefined || typeof value === type;
  }
}

/** What is wrong with a value itself; null if that may be said of its entries and keys only. */
function ownFault(value: unknown, shape: Shape): Fault['what'] | null {
  const { only, among, least = Number.NEGATIVE_INFINITY, most = Number.POSITIVE_INFINITY, pattern } = shape;
  if (!isOfType(shape, value)) return 'wrong-type';
  if (only !== undefined) return value === only ? null : 'other-value';
  if (among !== undefined) return among.includes(value as string) ? null : 'other-value';
  const size = typeof value === 'number' ? value : ((value as { readonly length?: number } | null)?.length ?? 0);
  if (shape.type !== undefined && shape.type !== 'object' && shape.type !== 'boolean') {
    if (size < least) return 'too-small';
    if (size > most) return 'too-big';
  }
  return pattern === undefined || new RegExp(pattern).test(value as string) ? null : 'wrong-form';
}

/**
 * Finds what is wrong with the shape of a JSON value, in the order of the text: one fault of each value, the most basic one.
 *
 * @param path - leads to the value
 * @param tell - gets each fault; it may throw to end the search
 */
export function findFaults(value: unknown, shape: Shape, path: Path, tell: (fault: Fault) => void): void {
  if (value === null && shape.nullable) return;
  const own = ownFault(value, shape);
  if (own !== null) {
    tell({ what: own, path, value, shape });
    return;
  }
  const { each, keys } = shape;
  if (each !== undefined) for (const [i, entry] of (value as unknown[]).entries()) findFaults(entry, each, [...path, i], tell);
  if (keys === undefined) return;
  for (const [key, entry] of Object.entries(value as object)) {
    if (Object.hasOwn(keys, key)) findFaults(entry, keys[key], [...path, key], tell);
    else if (!isExtension(key)) tell({ what: 'unknown-key', path: [...path, key], value: entry, shape });
  }
  for (const [key, its] of Object.entries(keys)) {
    if (its.optional || Object.hasOwn(value as object, key)) continue;
    tell({ what: 'missing-key', path: [...path, key], value: undefined, shape: its });
  }
}

/** What contradicts itself in a level, without words. */
export type Contradiction =
  /** An id, or the name of a run, that was there before: `first` is the path of the object or the run that has it. */
  | { readonly what: 'repeated'; readonly path: Path; readonly name: string; readonly first: Path }
  /** A hold that does not end after it begins. */
  | { readonly what: 'reversed'; readonly path: Path; readonly press: number; readonly release: number };

/**
 * Finds what the shape alone does not say: ids and names of runs are unique, and every hold ends after it begins. Accepts any
 * JSON value and skips what has the wrong shape.
 */
export function* contradictionsIn(level: unknown): Generator<Contradiction, void, undefined> {
  const owners = new Map<string, Path>();
  for (const list of OBJECT_LISTS) {
    const entries = listOf(keyOf(level, list));
    for (let i = 0; i < entries.length; i++) {
      const id = keyOf(entries[i], 'id');
      if (typeof id !== 'string') continue;
      const first = owners.get(id);
      if (first === undefined) owners.set(id, [list, i]);
      else yield { what: 'repeated', path: [list, i, 'id'], name: id, first };
    }
  }
  const runs = listOf(keyOf(level, 'runs'));
  const names = new Map<unknown, Path>();
  for (let r = 0; r < runs.length; r++) {
    const name = keyOf(runs[r], 'name');
    const first = names.get(name);
    if (first === undefined) names.set(name, ['runs', r]);
    // an empty name is none, which the shape says
    else if (typeof name === 'string' && name !== '') yield { what: 'repeated', path: ['runs', r, 'name'], name, first };
    const holds = listOf(keyOf(runs[r], 'holds'));
    for (let h = 0; h < holds.length; h++) {
      const hold = holds[h];
      if (!Array.isArray(hold) || hold.length !== 2) continue;
      const [press, release] = hold as unknown[];
      if (typeof press !== 'number' || typeof release !== 'number' || release > press) continue;
      yield { what: 'reversed', path: ['runs', r, 'holds', h], press, release };
    }
  }
}

const listOf = (value: unknown): readonly unknown[] => (Array.isArray(value) ? value : []);

const keyOf = (value: unknown, key: string): unknown =>
  typeof value === 'object' && value !== null && Object.hasOwn(value, key) ? (value as Record<string, unknown>)[key] : undefined;
