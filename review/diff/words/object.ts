import { type Field, KINDS, type NumberField, type ObjectKind } from '../../../schema/index.ts';
import type { FieldChange, Json, PartChange } from '../change.ts';
import { moveInWords, numberInWords, numbersApart } from './numbers.ts';
import { valueChangeInWords } from './values.ts';

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
