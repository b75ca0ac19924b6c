import { Failure, inWords } from './failure.ts';
import type { Shape } from './shape.ts';

type JsonObject = Readonly<Record<string, unknown>>;

const NAMES = {
  number: 'a number',
  integer: 'a whole number',
  boolean: 'true or false',
  string: 'a text',
  array: 'a list',
  object: 'an object',
};

function isOfType(type: Shape['type'], value: unknown): boolean {
  switch (type) {
    case undefined:
      return true;
    case 'array':
      return Array.isArray(value);
    case 'object':
      return typeof value === 'object' && value !== null && !Array.isArray(value);
    case 'integer':
      return Number.isInteger(value);
    default:
      return typeof value === type;
  }
}

/**
 * Checks a JSON value: keys, types, limits.
 * @param path leads to the value; it is changed and restored
 * @throws {Failure} if the value has another shape
 */
export function checkShape(value: unknown, shape: Shape, path: (string | number)[] = []): void {
  const { type, least = Number.NEGATIVE_INFINITY, most = Number.POSITIVE_INFINITY, only, pattern, each, keys } = shape;
  const fail = (expected: string, found = inWords(value)): never => {
    throw new Failure(`expected ${expected}, found ${found}`, path);
  };
  const check = (inner: unknown, its: Shape, step: string | number): void => {
    path.push(step);
    checkShape(inner, its, path);
    path.pop();
  };

  if (only !== undefined && value !== only) fail(inWords(only));
  if (!isOfType(type, value)) fail(NAMES[type as keyof typeof NAMES]);
  const isNumber = typeof value === 'number';
  const size = isNumber ? value : ((value as { readonly length?: number } | null)?.length ?? 0);
  if ((isNumber || each !== undefined || type === 'string') && !(size >= least && size <= most)) {
    const limits = `${size < least ? 'at least' : 'at most'} ${size < least ? least : most}`;
    if (isNumber) fail(`a number of ${limits}`);
    else fail(`${limits} ${each === undefined ? 'characters' : 'entries'}`, String(size));
  }
  if (pattern !== undefined && !new RegExp(pattern).test(value as string)) fail(`a text that matches ${pattern}`);
  if (each !== undefined) for (const [i, entry] of (value as unknown[]).entries()) check(entry, each, i);
  if (keys === undefined) return;
  for (const [key, entry] of Object.entries(value as JsonObject)) {
    if (key.startsWith('x-')) continue;
    if (!Object.hasOwn(keys, key)) fail(`one of the keys ${Object.keys(keys).join(', ')}`, `the key ${inWords(key)}`);
    check(entry, keys[key], key);
  }
  for (const [key, its] of Object.entries(keys)) {
    if (!its.optional && !Object.hasOwn(value as object, key)) fail(`the key ${inWords(key)}`, 'none of this name');
  }
}
