/** An object of a JSON file. */
export type Json = Readonly<Record<string, unknown>>;

/** Whether a JSON value is an object, and neither a list nor null. */
export const isObject = (value: unknown): value is Json => typeof value === 'object' && value !== null && !Array.isArray(value);

/**
 * Whether two JSON values are equal, in any order of keys.
 *
 * @param a - one value
 * @param b - the other
 * @returns whether they are equal
 */
export function isSame(a: unknown, b: unknown): boolean {
  if (a === b) return true;
  if (Array.isArray(a) && Array.isArray(b)) return a.length === b.length && a.every((entry, i) => isSame(entry, b[i]));
  if (!isObject(a) || !isObject(b)) return false;
  const keys = Object.keys(a);
  if (keys.length !== Object.keys(b).length) return false;
  return keys.every((key) => Object.hasOwn(b, key) && isSame(a[key], b[key]));
}

/** Keys with this prefix are free for anyone to use: they are kept and not checked. */
const PREFIX = 'x-';

/** A copy of a JSON value without the keys that begin with x-. Recursive, so only for values of limited depth. */
export function withoutExtensions(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(withoutExtensions);
  if (typeof value !== 'object' || value === null) return value;
  const kept = Object.entries(value).filter(([key]) => !key.startsWith(PREFIX));
  // fromEntries defines keys; an assignment to __proto__ would set the prototype
  return Object.fromEntries(kept.map(([key, inner]) => [key, withoutExtensions(inner)]));
}
