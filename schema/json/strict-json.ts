import { explainMistake } from './json-failures.ts';
import { scanJson } from './scan-json.ts';
import { createPlaceFinder } from './text-place.ts';

/** The value of a JSON text, or the first thing that is wrong with it, and where. */
export type StrictJson =
  | { readonly ok: true; readonly value: unknown }
  | { readonly ok: false; readonly message: string; readonly line: number; readonly column: number };

/**
 * Reads a JSON text that a person or a stranger wrote, as strictly as a level file: a key that an object has twice is a mistake,
 * as is a number beyond the doubles. `JSON.parse` would take the last of two values, and another program the first.
 */
export function strictJson(text: string): StrictJson {
  const { failure, repeated } = scanJson(text);
  const first = failure ?? repeated[0];
  if (first === undefined) return { ok: true, value: JSON.parse(text) };
  const { message, offset = 0 } = explainMistake(text, first);
  return { ok: false, message, ...createPlaceFinder(text)(offset) };
}
