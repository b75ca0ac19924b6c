import { ALLOWABLE_CODES, OBJECT_LISTS, RULE_NAMES, SINGLE_KINDS } from '../basics/index.ts';
import { LEVEL_SHAPE, type LevelFile, notesInOrder } from './shape.ts';

type Json = { readonly [key: string]: unknown };

const { keys } = LEVEL_SHAPE;
const run = keys.runs.each;

/** The order of keys in a file is that of the schema. */
const KEYS = {
  level: Object.keys(keys),
  rules: RULE_NAMES,
  allow: ALLOWABLE_CODES,
  runs: Object.keys(run.keys),
  notes: Object.keys(run.keys.notes.each.keys),
  conflicts: Object.keys(keys.conflicts.each.keys),
  ...Object.fromEntries(SINGLE_KINDS.map((kind) => [kind, Object.keys(keys[kind].keys)])),
  ...Object.fromEntries(OBJECT_LISTS.map((list) => [list, Object.keys(keys[list].each.keys)])),
} as { readonly [part: string]: readonly string[] };

/** Entries in canonical order: the keys in `order` first, then the others as they come, without undefined values. */
function entriesOf(object: Json, order: readonly string[]): [string, unknown][] {
  const known = order.filter((key) => Object.hasOwn(object, key)).map((key): [string, unknown] => [key, object[key]]);
  const others = Object.entries(object).filter(([key]) => !order.includes(key));
  return [...known, ...others].filter(([, value]) => value !== undefined);
}

/** A JSON value on one line. Numbers have the shortest form that reads back the same. */
function inline(value: unknown, order: readonly string[] = []): string {
  if (typeof value === 'number' && !Number.isFinite(value)) throw new RangeError(`a level file can't hold the number ${value}`);
  if (typeof value !== 'object' || value === null) return JSON.stringify(value);
  if (Array.isArray(value)) return `[${value.map((entry) => inline(entry)).join(', ')}]`;
  const entries = entriesOf(value as Json, order).map(([key, inner]) => `${JSON.stringify(key)}: ${inline(inner)}`);
  return entries.length === 0 ? '{}' : `{ ${entries.join(', ')} }`;
}

/** `open`, one row per line, `close`; on a single line when there are no rows. */
function block(open: string, rows: readonly string[], close: string, indent: string): string {
  if (rows.length === 0) return open + close;
  return `${open}\n${rows.map((row) => `${indent}  ${row}`).join(',\n')}\n${indent}${close}`;
}

function formatRun(value: Json, indent: string): string {
  const list = (rows: readonly string[]): string => block('[', rows, ']', `${indent}  `);
  const rows = entriesOf(value, KEYS.runs).map(([key, inner]) => {
    let text: string;
    if (key === 'holds' && Array.isArray(inner)) text = list(inner.map((hold) => inline(hold)));
    else if (key === 'notes' && Array.isArray(inner)) text = list(notesInOrder(inner).map((note) => inline(note, KEYS.notes)));
    else text = inline(inner);
    return `${JSON.stringify(key)}: ${text}`;
  });
  return block('{', rows, '}', indent);
}

/** A conflict has a line for each value, so that both can be compared. */
function formatConflict(value: Json, indent: string): string {
  const rows = entriesOf(value, KEYS.conflicts).map(([key, inner]) => `${JSON.stringify(key)}: ${inline(inner)}`);
  return block('{', rows, '}', indent);
}

const ENTRIES: Readonly<Record<string, (value: Json, indent: string) => string>> = { runs: formatRun, conflicts: formatConflict };

function formatMember(key: string, value: unknown): string {
  if (key === 'allow' && typeof value === 'object' && value !== null) {
    const rows = entriesOf(value as Json, KEYS.allow).map(([code, reason]) => `${JSON.stringify(code)}: ${inline(reason)}`);
    return block('{', rows, '}', '  ');
  }
  if (!Array.isArray(value) || !Object.hasOwn(KEYS, key)) return inline(value, KEYS[key]);
  const rows = value.map((entry) => ENTRIES[key]?.(entry as Json, '    ') ?? inline(entry, KEYS[key]));
  return block('[', rows, ']', '  ');
}

/**
 * Writes a level file in the canonical layout: keys in the order of the schema and x- keys after them, one object, hold, note or allowed
 * problem per line, LF, and a line end at the end of the file. Notes are sorted by tick, other lists keep their order, what is
 * missing stays missing, and -0 is written as 0.
 *
 * @param file - the content of the file
 * @returns the text of the file
 * @throws {RangeError} for NaN and infinite numbers, which JSON cannot hold
 *
 * @example
 * ```ts
 * const reading = readLevel(text);
 * if (reading.ok) writeFileSync(path, formatLevel(withIds(reading.document.file)));
 * ```
 */
export function formatLevel(file: LevelFile): string {
  const rows = entriesOf(file, KEYS.level).map(([key, value]) => `${JSON.stringify(key)}: ${formatMember(key, value)}`);
  return `${block('{', rows, '}', '')}\n`;
}
