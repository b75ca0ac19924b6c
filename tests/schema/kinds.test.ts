// The table of kinds is consistent, and the format follows it.

import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  appearanceOf,
  appearanceOfObject,
  fieldsOf,
  formatLevel,
  isRequired,
  KINDS,
  kindOfList,
  type LevelFile,
  LISTED_KINDS,
  levelJsonSchema,
  listOf,
  NO_OBJECTS,
  OBJECT_KINDS,
  OBJECT_LISTS,
  PLACEABLES,
  placedAs,
  placesIn,
  readLevel,
  resolveLevel,
  SINGLE_KINDS,
  withIds,
} from '../../schema/index.ts';
import { arbitraryFile } from './arbitrary-file.ts';

type Json = Readonly<Record<string, unknown>>;

const BARE: LevelFile = { version: 1, name: 'bare', astronaut: { x: 0, y: 0 }, blackHole: { x: 0, y: 0 } };

const readOf = (file: LevelFile) => {
  const reading = readLevel(formatLevel(file));
  if (!reading.ok) throw new Error(reading.problems[0].message);
  return reading;
};

describe.each(OBJECT_KINDS)('%s', (kind) => {
  const { list, fields, places, vectors, radius, variant, one, many, about } = KINDS[kind];

  test('has fields with limits, a meaning, and a default within the limits if any', () => {
    for (const [name, field] of fieldsOf(kind)) {
      expect(field.about, name).not.toBe('');
      if (field.type === 'flag') continue;
      expect(field.least, name).toBeLessThan(field.most);
      expect(field.step, name).toBeGreaterThan(0);
      expect(field.step, name).toBeLessThanOrEqual(field.most - field.least);
      for (const value of [field.default, field.initial]) {
        if (value === undefined) continue;
        expect(value, name).toBeGreaterThanOrEqual(field.least);
        expect(value, name).toBeLessThanOrEqual(field.most);
      }
    }
  });

  test('has places, vectors and a radius among its fields', () => {
    expect(places[0]).toEqual(['x', 'y']);
    for (const name of places.flat()) expect(fields[name]).toMatchObject({ type: 'number', unit: 'px' });
    // a place has no default
    for (const name of places.flat()) expect(isRequired(fields[name])).toBe(true);
    for (const [x, y] of Object.values(vectors)) {
      expect(fields[x].type).toBe('number');
      expect(fields[y]).toMatchObject({ type: 'number', unit: (fields[x] as { unit: string }).unit });
    }
    if (radius !== null) expect(fields[radius]).toMatchObject({ type: 'number', unit: 'px' });
    const all = [...places.flat(), ...Object.values(vectors).flat(), ...(radius === null ? [] : [radius])];
    expect(new Set(all).size).toBe(all.length);
  });

  test('has names, and a variant only with a flag', () => {
    for (const words of [one, many, about]) expect(words).not.toBe('');
    expect(one).toBe(one.toLowerCase());
    if (variant !== undefined) expect(fields[variant.flag].type).toBe('flag');
  });

  test('has all required fields in a new object, except the place', () => {
    if (list === null) return;
    for (const [name, field] of fieldsOf(kind)) {
      if (places.flat().includes(name) || !isRequired(field)) continue;
      expect(field.type === 'number' && field.initial !== undefined, name).toBe(true);
    }
  });

  test('is in the JSON Schema with its fields, limits and required fields', () => {
    const { properties } = levelJsonSchema() as { properties: Record<string, Json & { items?: Json }> };
    const schema = list === null ? properties[kind] : properties[list].items;
    const own = Object.fromEntries(
      fieldsOf(kind).map(([name, field]) => [
        name,
        field.type === 'flag'
          ? { type: 'boolean', description: field.about }
          : { type: 'number', minimum: field.least, maximum: field.most, description: field.about },
      ]),
    );
    expect(schema).toMatchObject({ properties: own, description: about, additionalProperties: false });
    expect(Object.keys(schema?.properties as Json)).toEqual([...(list === null ? [] : ['id']), ...Object.keys(fields)]);
    expect(schema?.required).toEqual(fieldsOf(kind).flatMap(([name, field]) => (isRequired(field) ? [name] : [])));
  });

  test('gets its defaults if a file omits all optional fields', () => {
    const written = Object.fromEntries(fieldsOf(kind).flatMap(([name, field]) => (isRequired(field) ? [[name, 1]] : [])));
    const expected = Object.fromEntries(fieldsOf(kind).map(([name, field]) => [name, field.default ?? 1]));
    const file = { ...BARE, ...(list === null ? { [kind]: written } : { [list]: [written] }) } as LevelFile;
    const level = resolveLevel(file) as unknown as Readonly<Record<string, Json | Json[]>>;
    expect(list === null ? level[kind] : level[list]).toEqual(list === null ? expected : [{ id: null, ...expected }]);
    expect(Object.keys(list === null ? level[kind] : (level[list] as Json[])[0])).toEqual([
      ...(list === null ? [] : ['id']),
      ...Object.keys(fields),
    ]);
  });

  test('is refused with an unknown field, and with a number beyond its limits', () => {
    const written: Record<string, number> = Object.fromEntries(
      fieldsOf(kind).flatMap(([name, field]) => (isRequired(field) ? [[name, 1]] : [])),
    );
    const codesOf = (object: object) => {
      const reading = readLevel(JSON.stringify({ ...BARE, ...(list === null ? { [kind]: object } : { [list]: [object] }) }));
      return reading.ok ? [] : reading.problems.map(({ code }) => code);
    };
    expect(codesOf(written)).toEqual([]);
    expect(codesOf({ ...written, colour: 1 })).toEqual(['unknown-key']);
    for (const [name, field] of fieldsOf(kind)) {
      if (field.type === 'flag') expect(codesOf({ ...written, [name]: 1 }), name).toEqual(['wrong-type']);
      else
        for (const value of [field.least * 2 - 1, field.most * 2])
          expect(codesOf({ ...written, [name]: value }), name).toEqual(['out-of-limits']);
    }
  });
});

describe('the kinds', () => {
  test('have unique lists, names and letters', () => {
    const appearances = [
      ...OBJECT_KINDS.map((kind) => KINDS[kind]),
      ...OBJECT_KINDS.flatMap((kind) => KINDS[kind].variant ?? []),
    ];
    for (const key of ['one', 'many', 'letter'] as const) {
      const all = appearances.flatMap((appearance) => appearance[key] ?? []);
      expect(new Set(all).size, key).toBe(all.length);
    }
    expect(new Set(OBJECT_LISTS).size).toBe(LISTED_KINDS.length);
    for (const kind of LISTED_KINDS) expect(kindOfList(listOf(kind))).toBe(kind);
    expect([...SINGLE_KINDS, ...LISTED_KINDS].sort()).toEqual([...OBJECT_KINDS].sort());
    expect(Object.keys(NO_OBJECTS)).toEqual(OBJECT_LISTS);
  });

  test('can be placed if they have a list, as can their variants', () => {
    for (const placeable of PLACEABLES) {
      const { kind, flag } = placedAs(placeable);
      const object = flag === null ? {} : { [flag]: true };
      expect(appearanceOf(placeable)).toBe(appearanceOfObject(kind, object));
    }
    expect(new Set(PLACEABLES.map(appearanceOf)).size).toBe(PLACEABLES.length);
    expect(PLACEABLES).toEqual(expect.arrayContaining([...LISTED_KINDS]));
  });

  test('are read, written and read again unchanged in any level', () => {
    fc.assert(
      fc.property(arbitraryFile, (file) => {
        const once = readOf(withIds(file));
        const again = readOf(once.document.file);
        expect(again.level).toEqual(once.level);
        expect(again.document.text).toBe(once.document.text);
        for (const kind of LISTED_KINDS) {
          for (const object of once.level[listOf(kind)]) {
            expect(placesIn(kind, object)).toHaveLength(KINDS[kind].places.length);
            expect(placesIn(kind, object)[0]).toMatchObject({ x: object.x, y: object.y });
          }
        }
      }),
    );
  });
});
