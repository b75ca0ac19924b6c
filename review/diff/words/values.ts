import { type Field, KINDS, type NumberField, type ObjectKind } from '../../../schema/index.ts';
import type { FieldChange, Json, PartChange } from '../change.ts';

const LONGEST = 40;

/** A text in quotes: escaped so that it cannot control a terminal, and cut if it is long. */
export function quoted(text: string): string {
  const letters = [...text];
  const shown = letters.length > LONGEST ? `${letters.slice(0, LONGEST).join('')}…` : text;
  return jsonLine(shown);
}

/** A JSON value on one line, without characters that control a terminal. */
export const jsonLine = (value: unknown): string =>
  JSON.stringify(value).replace(/[\p{Cc}\p{Cf}\p{Zl}\p{Zp}]/gu, (c) => `\\u{${c.codePointAt(0)?.toString(16)}}`);

/** A key as it is; one that is no plain word in quotes. */
export const keyInWords = (key: string): string => (/^[\w$-]+$/.test(key) && key.length <= LONGEST ? key : quoted(key));

const isShort = (value: unknown): value is string | number | boolean =>
  typeof value === 'number' || typeof value === 'boolean' || (typeof value === 'string' && value.length <= LONGEST);

const valueInWords = (value: string | number | boolean): string =>
  typeof value === 'string' ? quoted(value) : typeof value === 'number' ? numberInWords(value) : String(value);

/** A change of any value: `x-author "Ann" -> "Ben"`, `x-notes changed`, `$schema added`. */
export function valueChangeInWords(change: FieldChange, name = keyInWords(change.key), unit = ''): string {
  const { before, after } = change;
  if (!Object.hasOwn(change, 'before')) return isShort(after) ? `${name} ${valueInWords(after)}${unit} added` : `${name} added`;
  if (!Object.hasOwn(change, 'after'))
    return isShort(before) ? `${name} ${valueInWords(before)}${unit} removed` : `${name} removed`;
  if (typeof before === 'number' && typeof after === 'number') {
    const [b, a] = numbersApart(before, after);
    return `${name} ${b} -> ${a}${unit}`;
  }
  return isShort(before) && isShort(after) ? `${name} ${valueInWords(before)} -> ${valueInWords(after)}` : `${name} changed`;
}

/** Smaller differences are not given as a number. */
const SMALLEST = 0.01;

/** A number in at most `digits` decimals, without an exponent where it is readable without, and without a minus zero. */
const rounded = (value: number, digits: number): string => String(Number(value.toFixed(digits)) + 0);

/** A number of a level: two decimals. */
const numberInWords = (value: number): string => rounded(value, 2);

/** Two different numbers, with as many decimals as show that they differ. */
export function numbersApart(before: number, after: number): readonly [string, string] {
  for (const digits of [2, 4, 6]) {
    const [b, a] = [rounded(before, digits), rounded(after, digits)];
    if (b !== a) return [b, a];
  }
  return [String(before + 0), String(after + 0)];
}

/** A length in px: `12 px`, `0.35 px`, `less than 0.01 px`. */
function lengthInWords(length: number): string {
  const size = Math.abs(length);
  if (size < SMALLEST) return `less than ${SMALLEST} px`;
  return `${rounded(size, size >= 10 ? 1 : 2)} px`;
}

/** A move: `12 px right and 3 px up`. */
function moveInWords(dx: number, dy: number): string {
  const isFar = Math.abs(dx) >= SMALLEST || Math.abs(dy) >= SMALLEST;
  if (!isFar) return lengthInWords(0);
  const parts: string[] = [];
  if (Math.abs(dx) >= SMALLEST) parts.push(`${lengthInWords(dx)} ${dx > 0 ? 'right' : 'left'}`);
  if (Math.abs(dy) >= SMALLEST) parts.push(`${lengthInWords(dy)} ${dy > 0 ? 'down' : 'up'}`);
  return parts.join(' and ');
}

/** Numbers of objects, from 1: `3`, `3 and 4`, `1 to 12`, `1 to 3, 7 and 9`; very many are cut. */
export function indicesInWords(indices: readonly number[]): string {
  const ranges: [number, number][] = [];
  for (const index of [...indices].sort((a, b) => a - b)) {
    const last = ranges[ranges.length - 1];
    if (last !== undefined && index === last[1] + 1) last[1] = index;
    else ranges.push([index, index]);
  }
  const words = ranges.flatMap(([from, to]) =>
    to - from < 2 ? Array.from({ length: to - from + 1 }, (_, i) => String(from + i + 1)) : [`${from + 1} to ${to + 1}`],
  );
  if (words.length > MOST_RANGES) return `${words.slice(0, MOST_RANGES).join(', ')} and others`;
  return words.length === 1 ? words[0] : `${words.slice(0, -1).join(', ')} and ${words[words.length - 1]}`;
}

const MOST_RANGES = 8;

const unitOf = ({ unit }: NumberField): string => (unit === null ? '' : ` ${unit}`);

const PLACES = ['', 'second ', 'third ', 'fourth '];

/** What changed in an object, in words that go after its name: `moved 12 px right`, `radius 16 -> 20 px`. */
export function objectClauses(kind: ObjectKind, { fields, keys }: Pick<PartChange, 'fields' | 'keys'>): string[] {
  const { fields: known, places } = KINDS[kind];
  const byKey = new Map(fields.map((field) => [field.key, field]));
  const inPlaces = new Set(places.flat());
  const clauses = movesOf(kind, byKey);
  for (const field of fields) {
    if (inPlaces.has(field.key)) continue;
    const about: Field | undefined = Object.hasOwn(known, field.key) ? known[field.key] : undefined;
    clauses.push(about === undefined ? valueChangeInWords(field) : fieldClause(about, field));
  }
  if (keys !== null) clauses.push('x- keys in another order');
  return clauses;
}

/** The moves of an object's places, as one if all of them moved alike. */
function movesOf(kind: ObjectKind, fields: ReadonlyMap<string, FieldChange>): string[] {
  const along = (key: string): number => {
    const field = fields.get(key);
    return field === undefined ? 0 : (field.after as number) - (field.before as number);
  };
  const moves = KINDS[kind].places.map(([x, y]) => [along(x), along(y)] as const);
  const [first] = moves;
  if (moves.every(([dx, dy]) => dx === first[0] && dy === first[1])) {
    return first[0] === 0 && first[1] === 0 ? [] : [`moved ${moveInWords(first[0], first[1])}`];
  }
  return moves.flatMap(([dx, dy], i) => {
    if (dx === 0 && dy === 0) return [];
    return [i === 0 ? `moved its first place ${moveInWords(dx, dy)}` : `moved its ${PLACES[i]}place ${moveInWords(dx, dy)}`];
  });
}

function fieldClause(about: Field, change: FieldChange): string {
  const name = about.label ?? change.key;
  // what is left out has the default value
  const [before, after] = [change.before ?? about.default, change.after ?? about.default];
  if (about.type === 'flag') {
    const now = about.ends[after === true ? 1 : 0];
    return before === after ? writtenOut(change, `${name}: ${String(after)}`) : `became ${now}`;
  }
  if (before === after) return writtenOut(change, `${name} ${numberInWords(after as number)}${unitOf(about)}`);
  const [b, a] = numbersApart(before as number, after as number);
  return `${name} ${b} -> ${a}${unitOf(about)}`;
}

/** A default value that was written, or is no longer: nothing else changes. */
const writtenOut = (change: FieldChange, what: string): string =>
  Object.hasOwn(change, 'after') ? `${what}, the default, is now written` : `${what}, the default, is no longer written`;

/** Where an object is: ` at (120, 40)`. */
export const placeInWords = (kind: ObjectKind, entry: Json): string => {
  const [[x, y]] = KINDS[kind].places;
  return ` at (${numberInWords(entry[x] as number)}, ${numberInWords(entry[y] as number)})`;
};
