import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  ASTRONAUT,
  addObject,
  alignObjects,
  BLACK_HOLE,
  copyObjects,
  createEditedLevel,
  deleteObjects,
  distributeObjects,
  duplicateObjects,
  type Edge,
  type FoundObject,
  keyAt,
  middleOf,
  moveObjects,
  objectsOf,
  pasteObjects,
  placesOf,
  type Recipe,
  radiusOf,
  readClipping,
  reorderObject,
  scaleRadius,
  setLevelProperty,
  setObjectProperty,
  setRadius,
} from '../../editor/core/document/index.ts';
import {
  fieldsOf,
  formatLevel,
  isRequired,
  KINDS,
  kindOfList,
  type LevelFile,
  LISTED_KINDS,
  type ListedKind,
  listOf,
  OBJECT_LISTS,
  type ObjectList,
  type Placeable,
} from '../../schema/index.ts';

const coordinate = fc.integer({ min: -200, max: 200 });
const radius = fc.constantFrom(4, 16, 32);

interface Listed {
  x: number;
  y: number;
}

/** Some objects of a kind, with required fields and possibly a radius. */
const some = (kind: ListedKind): fc.Arbitrary<Listed[]> => {
  const fields = fieldsOf(kind).flatMap(([name, field]): [string, fc.Arbitrary<unknown>][] => {
    if (name === KINDS[kind].radius) return [[name, isRequired(field) ? radius : fc.option(radius, { nil: undefined })]];
    return isRequired(field) ? [[name, coordinate]] : [];
  });
  return fc.array(fc.record(Object.fromEntries(fields)) as unknown as fc.Arbitrary<Listed>, { maxLength: 3 });
};

const lists = Object.fromEntries(LISTED_KINDS.map((kind) => [listOf(kind), some(kind)])) as Record<
  ObjectList,
  fc.Arbitrary<Listed[]>
>;

/** Small levels with whole numbers, an id on every object, some default radii, and missing lists. */
const smallFile: fc.Arbitrary<LevelFile> = fc
  .record({
    astronaut: fc.record({ x: coordinate, y: coordinate }),
    blackHole: fc.record({ x: coordinate, y: coordinate, radius: fc.option(radius, { nil: undefined }) }),
    ...lists,
  })
  .map((parts) => {
    const lists = OBJECT_LISTS.filter((list) => parts[list].length > 0).map((list) => [
      list,
      parts[list].map((object: object, i: number) => ({ id: `${list.slice(0, 3)}${i}`, ...object })),
    ]);
    return createEditedLevel({
      version: 1,
      name: 'small',
      astronaut: parts.astronaut,
      blackHole: parts.blackHole,
      ...Object.fromEntries(lists),
    }).file();
  });

const withKeys = fc.tuple(smallFile, fc.array(fc.nat(30), { maxLength: 6 })).map(([file, picks]) => ({
  file,
  keys: [...new Set(picks.map((n) => [...objectsOf(file).keys()][n % objectsOf(file).size]))],
}));

const fileAfter = (file: LevelFile, recipe: Recipe): LevelFile => {
  const level = createEditedLevel(file);
  const result = level.change('act', recipe);
  if (!result.ok) throw new Error(result.refusal.message);
  return level.file();
};
const foundIn = (file: LevelFile, key: string) => objectsOf(file).get(key) as FoundObject;
const places = (file: LevelFile) => new Map([...objectsOf(file)].map(([key, { object }]) => [key, { x: object.x, y: object.y }]));

/** A level in which only some objects are changed. */
function changed(file: LevelFile, keys: readonly string[], change: (found: FoundObject) => object): LevelFile {
  const one = (key: string) => (keys.includes(key) ? change(foundIn(file, key)) : foundIn(file, key).object);
  return {
    ...file,
    astronaut: one(ASTRONAUT),
    blackHole: one(BLACK_HOLE),
    ...Object.fromEntries(
      OBJECT_LISTS.flatMap((list) =>
        file[list] === undefined ? [] : [[list, file[list].map(({ id }) => one(id as string))] as const],
      ),
    ),
  } as LevelFile;
}

/** The default size of objects without a radius. */
const usual: Partial<Record<string, number>> = { blackHole: 18, alien: 25, mineral: 7 };
const half = ({ kind, object }: FoundObject, axis: 'x' | 'y'): number =>
  kind === 'astronaut' ? (axis === 'x' ? 10 : 16) : (object.radius ?? (usual[kind] as number));

type Numbers = Record<string, number>;

/** An object, moved as a whole. */
function moved({ kind, object }: Pick<FoundObject, 'kind' | 'object'>, dx: number, dy: number): FoundObject['object'] {
  const numbers = object as unknown as Numbers;
  const at = KINDS[kind].places.flatMap(([x, y]) => [
    [x, numbers[x] + dx],
    [y, numbers[y] + dy],
  ]);
  return { ...object, ...Object.fromEntries(at) };
}

/** The smallest and largest coordinate of an object along an axis, with all its places. */
function ends(found: FoundObject, axis: 'x' | 'y'): [low: number, high: number] {
  const along = KINDS[found.kind].places.map((pair) => (found.object as unknown as Numbers)[pair[axis === 'x' ? 0 : 1]]);
  return [Math.min(...along) - half(found, axis), Math.max(...along) + half(found, axis)];
}

const middleAlong = (found: FoundObject, axis: 'x' | 'y'): number => (ends(found, axis)[0] + ends(found, axis)[1]) / 2;

describe('objects', () => {
  it('are moved if they are chosen, and no others', () => {
    fc.assert(
      fc.property(withKeys, coordinate, coordinate, ({ file, keys }, dx, dy) => {
        const expected = changed(file, keys, (found) => moved(found, dx, dy));
        expect(fileAfter(file, moveObjects(keys, dx, dy))).toEqual(expected);
      }),
    );
  });

  it('are changed by two recipes in one step as by two steps', () => {
    fc.assert(
      fc.property(withKeys, withKeys, coordinate, ({ file, keys }, other, dx) => {
        const [one, two] = [moveObjects(keys, dx, 1), moveObjects([...other.keys, ...keys], 1, dx)];
        const both = fileAfter(file, (draft) => {
          one(draft);
          two(draft);
        });
        expect(both).toEqual(fileAfter(fileAfter(file, one), two));
      }),
    );
  });

  it('are aligned with the outermost one, and do not move along the other axis', () => {
    const edges: [Edge, 'x' | 'y', -1 | 0 | 1][] = [
      ['left', 'x', -1],
      ['centre', 'x', 0],
      ['right', 'x', 1],
      ['top', 'y', -1],
      ['middle', 'y', 0],
      ['bottom', 'y', 1],
    ];
    fc.assert(
      fc.property(withKeys, fc.constantFrom(...edges), ({ file, keys }, [edge, axis, side]) => {
        const objects = keys.map((key) => foundIn(file, key));
        const low = Math.min(...objects.map((found) => ends(found, axis)[0]));
        const high = Math.max(...objects.map((found) => ends(found, axis)[1]));
        const line = [low, (low + high) / 2, high][side + 1];
        const expected = changed(file, keys, (found) => {
          const [least, most] = ends(found, axis);
          const by = line - [least, (least + most) / 2, most][side + 1];
          return moved(found, axis === 'x' ? by : 0, axis === 'y' ? by : 0);
        });
        expect(fileAfter(file, alignObjects(file, keys, edge))).toEqual(expected);
      }),
      { numRuns: 120 },
    );
  });

  it('are distributed evenly between the outermost two, in their order', () => {
    fc.assert(
      fc.property(withKeys, fc.constantFrom<'x' | 'y'>('x', 'y'), ({ file, keys }, axis) => {
        const spread = fileAfter(file, distributeObjects(file, keys, axis));
        const before = keys.map((key) => foundIn(file, key)).sort((a, b) => middleAlong(a, axis) - middleAlong(b, axis));
        const middles = before.map((found) => middleAlong(found, axis));
        const step = (middles[middles.length - 1] - middles[0]) / (before.length - 1);
        const now = places(spread);
        for (const [i, { key }] of before.entries()) {
          const at = before.length < 3 ? middles[i] : middles[0] + i * step;
          expect(middleAlong(foundIn(spread, key), axis)).toBeCloseTo(at, 9);
        }
        const others = axis === 'x' ? 'y' : 'x';
        for (const [key, place] of places(file)) {
          expect(now.get(key)?.[others]).toBe(place[others]);
          if (!keys.includes(key)) expect(now.get(key)).toEqual(place);
        }
      }),
      { numRuns: 120 },
    );
  });

  it('can be removed, except the two that every level has; an empty list is omitted', () => {
    fc.assert(
      fc.property(withKeys, ({ file, keys }) => {
        const gone = fileAfter(file, deleteObjects(keys));
        const left = [...objectsOf(file).keys()].filter((key) => !keys.includes(key) || key.startsWith('@'));
        expect([...objectsOf(gone).keys()]).toEqual(left);
        for (const list of OBJECT_LISTS) expect(gone[list]?.length).not.toBe(0);
      }),
    );
  });

  it('are duplicated beside themselves, at the end of their list, with all fields', () => {
    fc.assert(
      fc.property(withKeys, coordinate, coordinate, ({ file, keys }, dx, dy) => {
        const level = createEditedLevel(file);
        const result = level.change('Duplicate', duplicateObjects(keys, dx, dy));
        const added: unknown[] = [];
        for (const list of OBJECT_LISTS) {
          const old = file[list] ?? [];
          const now = level.file()[list] ?? [];
          expect(now.slice(0, old.length)).toEqual(old);
          expect(level.file()[list] === undefined).toBe(file[list] === undefined);
          const copies = now.slice(old.length);
          const expected = old.filter(({ id }) => keys.includes(id as string));
          expect(copies.map((copy) => ({ ...copy, id: null }))).toEqual(
            expected.map((object) => ({ ...moved({ kind: kindOfList(list), object }, dx, dy), id: null })),
          );
          added.push(...copies.map(({ id }) => id));
        }
        expect(result).toEqual({ ok: true, added });
      }),
    );
  });

  it('are pasted as they were copied, but moved, after the existing objects', () => {
    fc.assert(
      fc.property(withKeys, smallFile, coordinate, coordinate, ({ file, keys }, into, dx, dy) => {
        const text = copyObjects(file, keys);
        const copied = keys.filter((key) => !key.startsWith('@'));
        if (text === null) {
          expect(copied).toEqual([]);
          return;
        }
        const reading = readClipping(text);
        if (!reading.ok) throw new Error(reading.refusal.message);
        expect(reading.count).toBe(copied.length);
        const pasted = fileAfter(into, pasteObjects(reading.clipping, dx, dy));
        for (const list of OBJECT_LISTS) {
          const old = into[list] ?? [];
          const expected = (file[list] ?? []).filter(({ id }) => copied.includes(id as string));
          const now = pasted[list] ?? [];
          expect(now.slice(0, old.length)).toEqual(old);
          expect(now.slice(old.length).map((object) => ({ ...object, id: null }))).toEqual(
            expected.map((object) => ({ ...moved({ kind: kindOfList(list), object }, dx, dy), id: null })),
          );
        }
        const all = copied.flatMap((key) => placesOf(foundIn(file, key)));
        const middle = (values: number[]) => (Math.min(...values) + Math.max(...values)) / 2;
        expect(middleOf(reading.clipping)).toEqual({ x: middle(all.map(({ x }) => x)), y: middle(all.map(({ y }) => y)) });
      }),
    );
  });

  it('can also be pasted from the text of a whole level', () => {
    fc.assert(
      fc.property(smallFile, (file) => {
        const count = OBJECT_LISTS.reduce((sum, list) => sum + (file[list]?.length ?? 0), 0);
        expect(readClipping(formatLevel(file))).toMatchObject(count === 0 ? { ok: false } : { ok: true, count });
      }),
    );
  });

  it('can not be pasted from other JSON', () => {
    for (const text of ['null', '7', '"asteroids"', 'true', '[{"asteroids":[]}]', '{"asteroids":null}', '{"runs":[]}'])
      expect(readClipping(text).ok).toBe(false);
  });

  it('are pasted at their old place if no offset is given', () => {
    const clipping = { novae: [{ x: 3, y: 4, radius: 16 }] };
    const empty: LevelFile = { version: 1, name: 'a', astronaut: { x: 0, y: 0 }, blackHole: { x: 0, y: 0 } };
    expect(fileAfter(empty, pasteObjects(clipping)).novae).toMatchObject(clipping.novae);
  });

  it('move to a place in their list, or to the end if there is no such place', () => {
    fc.assert(
      fc.property(smallFile, fc.nat(30), fc.integer({ min: -3, max: 6 }), (file, n, to) => {
        const key = [...objectsOf(file).keys()][n % objectsOf(file).size];
        const expected: LevelFile = { ...file };
        const { list, object } = foundIn(file, key);
        if (list !== null) {
          const others = (file[list] ?? []).filter(({ id }) => id !== key);
          const place = to < 0 ? 0 : to;
          expected[list] = [...others.slice(0, place), object, ...others.slice(place)] as never;
        }
        expect(fileAfter(file, reorderObject(key, to))).toEqual(expected);
      }),
    );
  });

  it('have the radius of the file, or the default of their kind; the astronaut has none', () => {
    fc.assert(
      fc.property(smallFile, (file) => {
        for (const found of objectsOf(file).values())
          expect(radiusOf(found)).toBe(found.kind === 'astronaut' ? null : (found.object.radius ?? usual[found.kind]));
      }),
    );
    const nova = { kind: 'nova', object: { x: 0, y: 0 } } as const;
    expect(radiusOf(nova)).toBeNull();
  });

  it('can get a radius, or be scaled; the astronaut is skipped', () => {
    fc.assert(
      fc.property(withKeys, radius, ({ file, keys }, size) => {
        const round = keys.filter((key) => key !== ASTRONAUT);
        expect(fileAfter(file, setRadius(keys, size))).toEqual(
          changed(file, round, ({ object }) => ({ ...object, radius: size })),
        );
        expect(fileAfter(file, scaleRadius(file, [...keys, 'nowhere'], size / 8))).toEqual(
          changed(file, round, (found) => ({ ...found.object, radius: (half(found, 'x') * size) / 8 })),
        );
      }),
    );
  });

  it('and the level can get a typed property, or omit it', () => {
    const level = createEditedLevel({
      ...{ version: 1, name: 'a', astronaut: { x: 0, y: 0 }, blackHole: { x: 0, y: 0 }, range: 100, recoil: true },
    });
    level.change('Type', setLevelProperty('range', 300));
    level.change('Type', setLevelProperty('recoil', undefined));
    expect(level.file()).toEqual({ version: 1, name: 'a', astronaut: { x: 0, y: 0 }, blackHole: { x: 0, y: 0 }, range: 300 });
  });

  it('can get a typed property, and lose an omitted one', () => {
    const level: LevelFile = {
      version: 1,
      name: 'a',
      astronaut: { x: 0, y: 0 },
      blackHole: { x: 0, y: 0, radius: 30 },
      asteroids: [{ id: 'aa', x: 1, y: 2, radius: 16, hot: true }],
    };
    expect(fileAfter(level, setObjectProperty(['aa'], 'y', 9)).asteroids).toEqual([
      { id: 'aa', x: 1, y: 9, radius: 16, hot: true },
    ]);
    expect(fileAfter(level, setObjectProperty(['aa'], 'hot', undefined)).asteroids).toEqual([
      { id: 'aa', x: 1, y: 2, radius: 16 },
    ]);
    expect(fileAfter(level, setObjectProperty([BLACK_HOLE], 'radius', undefined)).blackHole).toEqual({ x: 0, y: 0 });
    expect(Object.keys(fileAfter(level, setObjectProperty(['aa'], 'x', 9)).asteroids?.[0] ?? {})).toEqual([
      'id',
      'x',
      'y',
      'radius',
      'hot',
    ]);
  });

  it('are placed after the others, with the default radius of their kind or the given one', () => {
    const kinds: [Placeable, (typeof OBJECT_LISTS)[number], number | undefined][] = [
      ['asteroid', 'asteroids', 16],
      ['hot', 'asteroids', 16],
      ['nova', 'novae', 16],
      ['repulsor', 'repulsors', 32],
      ['alien', 'aliens', undefined],
      ['mineral', 'minerals', undefined],
    ];
    fc.assert(
      fc.property(
        smallFile,
        fc.constantFrom(...kinds),
        fc.option(radius, { nil: undefined }),
        (file, [kind, list, size], given) => {
          const added = fileAfter(file, addObject(kind, 1, 2, given));
          const objects = added[list] ?? [];
          const radius = given ?? size;
          const { id, ...rest } = objects.at(-1) ?? {};
          expect(id).toMatch(/^[a-z0-9]+$/);
          expect(rest).toEqual({
            x: 1,
            y: 2,
            ...(radius === undefined ? {} : { radius }),
            ...(kind === 'hot' ? { hot: true } : {}),
          });
          const left = objects.length === 1 && file[list] === undefined ? undefined : objects.slice(0, -1);
          expect({ ...added, [list]: left }).toEqual({ ...file, [list]: left === undefined ? undefined : file[list] });
        },
      ),
    );
  });

  it('are identified by key, kind, index in the list and pointer', () => {
    fc.assert(
      fc.property(smallFile, (file) => {
        const objects = [...objectsOf(file).values()];
        expect(objects.slice(0, 2)).toEqual([
          { key: ASTRONAUT, kind: 'astronaut', list: null, index: 0, object: file.astronaut, pointer: '/astronaut' },
          { key: BLACK_HOLE, kind: 'blackHole', list: null, index: 0, object: file.blackHole, pointer: '/blackHole' },
        ]);
        const expected = OBJECT_LISTS.flatMap((list, n) =>
          (file[list] ?? []).map((object, index) => ({
            ...{ key: object.id, kind: LISTED_KINDS[n], list, index, object, pointer: `/${list}/${index}` },
          })),
        );
        expect(objects.slice(2)).toEqual(expected);
        for (const { key, pointer } of objects) expect([pointer, `${pointer}/x`].map((p) => keyAt(file, p))).toEqual([key, key]);
        expect(objectsOf(file)).toBe(objectsOf(file));
        expect(keyAt(file, '/asteroids/77')).toBeNull();
        expect(keyAt({ ...file, novae: undefined }, '/novae/0')).toBeNull();
      }),
    );
    // a level that has not been settled yet
    const bare: LevelFile = {
      version: 1,
      name: 'a',
      astronaut: { x: 0, y: 0 },
      blackHole: { x: 0, y: 0 },
      aliens: [{ x: 1, y: 2 }],
    };
    expect([...objectsOf(bare).keys()]).toEqual([ASTRONAUT, BLACK_HOLE]);
    expect(keyAt(bare, '/aliens/0')).toBeNull();
  });
});
