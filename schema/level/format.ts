import { ALLOWABLE_CODES, OBJECT_LISTS, RULE_NAMES, SINGLE_KINDS } from '../basics/index.ts';
import { block, entriesOf, inline, type Json } from '../json/index.ts';
import { LEVEL_SHAPE, type LevelFile, notesInOrder } from './shape.ts';

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
