import { LEVEL_SHAPE } from './level-shape.ts';
import type { Shape } from './shape.ts';

type Test = (value: unknown) => boolean;

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
      const test = testOf(each ?? {});
      return (value) => Array.isArray(value) && value.length >= least && value.length <= most && value.every(test);
    }
    case 'object':
      return testOfObject(keys ?? {});
  }
}

function testOfObject(keys: NonNullable<Shape['keys']>): Test {
  const tests = new Map(Object.entries(keys).map(([key, shape]) => [key, testOf(shape)]));
  const needed = Object.keys(keys).filter((key) => keys[key].optional !== true);
  return (value) => {
    if (typeof value !== 'object' || value === null || Array.isArray(value)) return false;
    const object = value as Readonly<Record<string, unknown>>;
    for (const key of Object.keys(object)) {
      const test = tests.get(key);
      if (test === undefined ? !key.startsWith('x-') : !test(object[key])) return false;
    }
    return needed.every((key) => Object.hasOwn(object, key));
  };
}

let test: Test | null = null;

/**
 * Whether a JSON value has the shape of a level file: keys, types, limits. The functions that test this are made once, of the
 * table.
 */
export function fitsLevel(value: unknown): boolean {
  test ??= testOf(LEVEL_SHAPE);
  return test(value);
}
