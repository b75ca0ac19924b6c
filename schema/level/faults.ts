import type { Path } from '../basics/index.ts';
import { LEVEL_SHAPE, type Shape, type ShapesByKey } from './shape.ts';

type Test = (value: unknown) => boolean;

let test: Test | null = null;

/**
 * Whether a JSON value has the shape of a level file: keys, types, limits. The functions that test this are made once, of the
 * shape. Nearly every file fits, so only the others are looked through for their faults, which takes several times as long.
 */
export function fitsLevel(value: unknown): boolean {
  test ??= testOf(LEVEL_SHAPE);
  return test(value);
}

function testOf({
  type,
  least = Number.NEGATIVE_INFINITY,
  most = Number.POSITIVE_INFINITY,
  only,
  pattern,
  each,
  keys,
}: Shape): Test {
  if (only !== undefined) return (value) => value === only;
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

export const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** Whether a key of an object is free for anyone to use: such keys are kept and not checked. */
export const isExtension = (key: string): boolean => key.startsWith('x-');

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
  const { only, least = Number.NEGATIVE_INFINITY, most = Number.POSITIVE_INFINITY, pattern } = shape;
  if (!isOfType(shape, value)) return 'wrong-type';
  if (only !== undefined) return value === only ? null : 'other-value';
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
