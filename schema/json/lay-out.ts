import type { Json } from './values.ts';

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
