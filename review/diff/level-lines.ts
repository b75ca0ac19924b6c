import {
  appearanceOfObject,
  type Field,
  fieldsOf,
  KINDS,
  type LevelFile,
  LISTED_KINDS,
  listOf,
  notesInOrder,
  type ObjectKind,
  SINGLE_KINDS,
} from '../../schema/index.ts';
import { isEqual, type Json } from './change.ts';
import { jsonLine, keyInWords } from './words/index.ts';

const unitOf = (field: Field): string => (field.type === 'number' && field.unit !== null ? ` ${field.unit}` : '');

/** An object on one line: what it is, its id, where it is, and every other field that is written. */
function objectLine(kind: ObjectKind, object: Json): string {
  const { places, fields: known } = KINDS[kind];
  const at = places.map(([x, y]) => `(${jsonLine(object[x])}, ${jsonLine(object[y])})`).join(' and ');
  const inPlaces = new Set(places.flat());
  const fields = fieldsOf(kind).flatMap(([key, field]) =>
    inPlaces.has(key) || object[key] === undefined ? [] : [`${field.label ?? key} ${jsonLine(object[key])}${unitOf(field)}`],
  );
  const own = Object.keys(object)
    .filter((key) => key !== 'id' && !Object.hasOwn(known, key) && object[key] !== undefined)
    .map((key) => `${keyInWords(key)} ${jsonLine(object[key])}`);
  const id = object.id === undefined ? '' : ` ${String(object.id)}`;
  return [`${appearanceOfObject(kind, object).one}${id} at ${at}`, ...fields, ...own].join(', ');
}

/** The keys of a run that have lines of their own. */
const LINES_OF_RUN: ReadonlySet<string> = new Set(['name', 'holds', 'notes']);

/** The keys of a level that have lines of their own. */
const LISTED = new Set<string>(['name', 'runs', ...SINGLE_KINDS, ...LISTED_KINDS.map(listOf)]);

/**
 * A level as text in which every object, hold and other key has a line of its own, for comparing it line by line. Objects are
 * sorted by kind and id, so that their order in the file does not matter.
 * @param file the content of a valid file
 */
export function levelInLines(file: LevelFile): string {
  const level = file as unknown as Json;
  const lines = [`level ${jsonLine(file.name)}`];
  for (const [key, value] of Object.entries(level)) {
    if (LISTED.has(key) || value === undefined) continue;
    const isMap = typeof value === 'object' && value !== null && !Array.isArray(value) && !key.startsWith('x-');
    if (isMap) lines.push(...Object.entries(value).map(([name, inner]) => `${key}, ${keyInWords(name)} ${jsonLine(inner)}`));
    else lines.push(`${keyInWords(key)} ${jsonLine(value)}`);
  }
  for (const kind of SINGLE_KINDS) lines.push(objectLine(kind, level[kind] as Json));
  for (const kind of LISTED_KINDS) {
    const entries = (level[listOf(kind)] ?? []) as readonly Json[];
    const sorted = entries.map((entry) => ({ id: String(entry.id ?? '~'), line: objectLine(kind, entry) }));
    lines.push(...sorted.sort((p, q) => (p.id < q.id || (p.id === q.id && p.line < q.line) ? -1 : 1)).map(({ line }) => line));
  }
  for (const run of file.runs ?? []) {
    const own = Object.entries(run).filter(([key, value]) => !LINES_OF_RUN.has(key) && !isEqual(value, undefined));
    lines.push([`run ${jsonLine(run.name)}`, ...own.map(([key, value]) => `${keyInWords(key)} ${jsonLine(value)}`)].join(', '));
    for (const [press, release] of run.holds) lines.push(`  hold ${press}-${release}`);
    for (const { tick, text, ...more } of notesInOrder(run.notes ?? [])) {
      const others = Object.entries(more).map(([key, value]) => `, ${keyInWords(key)} ${jsonLine(value)}`);
      lines.push(`  note ${tick} ${jsonLine(text)}${others.join('')}`);
    }
  }
  return lines.map((line) => `${line}\n`).join('');
}
