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

// The canonical layout of files: known keys first, an entry a line.

/** Entries in canonical order: the keys in `order` first, then the others as they come, without undefined values. */
export function entriesOf(object: Json, order: readonly string[]): [string, unknown][] {
  const known = order.filter((key) => Object.hasOwn(object, key)).map((key): [string, unknown] => [key, object[key]]);
  const others = Object.entries(object).filter(([key]) => !order.includes(key));
  return [...known, ...others].filter(([, value]) => value !== undefined);
}

/**
 * A JSON value on one line. Numbers have the shortest form that reads back the same.
 *
 * @throws {RangeError} for NaN and infinite numbers, which JSON cannot hold
 */
export function inline(value: unknown, order: readonly string[] = []): string {
  if (typeof value === 'number' && !Number.isFinite(value)) throw new RangeError(`JSON can't hold the number ${value}`);
  if (typeof value !== 'object' || value === null) return JSON.stringify(value);
  if (Array.isArray(value)) return `[${value.map((entry) => inline(entry)).join(', ')}]`;
  const entries = entriesOf(value as Json, order).map(([key, inner]) => `${JSON.stringify(key)}: ${inline(inner)}`);
  return entries.length === 0 ? '{}' : `{ ${entries.join(', ')} }`;
}

/** `open`, one row per line, `close`; on a single line when there are no rows. */
export function block(open: string, rows: readonly string[], close: string, indent: string): string {
  if (rows.length === 0) return open + close;
  return `${open}\n${rows.map((row) => `${indent}  ${row}`).join(',\n')}\n${indent}${close}`;
}
