import fc from 'fast-check';

/** Pieces of text that break a level in special ways. */
const PIECES = [
  ...['NaN', '1e999', '-1e308', '0', '-1', '1e-320', 'null', 'true', '[]', '{}', '""', '"', ',', '}', ']', '[', '{', '\\', '/*'],
  ...['"__proto__":1,', '"x":2,', '"x-a":[],', '"version": 2', '\ufeff', '\u0000', '\ud800', '[5,5]', '"hot": 1', '\n'],
];

/** A change of a text. */
export type Edit = readonly [at: number, length: number, kind: 'delete' | 'double' | 'swap' | 'insert' | 'number', piece: string];

/** Any change of a text. */
export const edit: fc.Arbitrary<Edit> = fc.tuple(
  fc.nat(),
  fc.integer({ min: 1, max: 30 }),
  fc.constantFrom('delete', 'double', 'swap', 'insert', 'number'),
  fc.constantFrom(...PIECES),
);

/** A text after a change. */
export function apply(text: string, [at, length, kind, piece]: Edit): string {
  const i = at % (text.length + 1);
  const part = text.slice(i, i + length);
  const rest = text.slice(i + length);
  switch (kind) {
    case 'delete':
      return text.slice(0, i) + rest;
    case 'double':
      return text.slice(0, i) + part + part + rest;
    case 'swap':
      return text.slice(0, i) + rest.slice(0, length) + part + rest.slice(length);
    case 'insert':
      return text.slice(0, i) + piece + text.slice(i);
    case 'number':
      return text.slice(0, i) + text.slice(i).replace(/-?\d[\d.e-]*/, () => piece);
  }
}
