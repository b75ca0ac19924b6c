// The editor follows the table of kinds: each kind has a drawing, a tool, fields and a row in the outline, and every operation
// keeps it valid and complete.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { COLOURS } from '../../editor/canvas/colours.ts';
import { extentOf } from '../../editor/canvas/extent.ts';
import { hitTest, objectsIn } from '../../editor/canvas/hit-test.ts';
import { type Figure, ON_CANVAS, put, signOf } from '../../editor/canvas/kinds.ts';
import { snapTargets } from '../../editor/canvas/snapping.ts';
import {
  addObject,
  alignObjects,
  copyObjects,
  createEditedLevel,
  deleteObjects,
  distributeObjects,
  duplicateObjects,
  type FoundObject,
  moveObjects,
  nameOf,
  objectsOf,
  pasteObjects,
  placesOf,
  type Recipe,
  radiusOf,
  readClipping,
  reorderObject,
  scaleRadius,
  setObjectProperty,
  setRadius,
} from '../../editor/core/document/index.ts';
import { TOOLS } from '../../editor/core/session/index.ts';
import { fieldsOf } from '../../editor/features/inspector/fields.ts';
import { objectRows } from '../../editor/features/outliner/object-rows.ts';
import { boxOf } from '../../engine/index.ts';
import { type Brush, DRAWINGS } from '../../phaser/index.ts';
import { mergeLevels } from '../../review/index.ts';
import {
  DEFAULT_RULES,
  type FieldName,
  fieldsOf as fieldsOfKind,
  formatLevel,
  KINDS,
  type LevelFile,
  LISTED_KINDS,
  listOf,
  OBJECT_KINDS,
  PLACEABLES,
  placedAs,
  readLevel,
} from '../../schema/index.ts';
import { arbitraryFile } from './arbitrary-file.ts';

const her = boxOf(DEFAULT_RULES);

const BARE: LevelFile = { version: 1, name: 'bare', astronaut: { x: -500, y: -500 }, blackHole: { x: 900, y: -500 } };

/** Textures that kinds share. */
const SHARED = ['glow'];

const fileAfter = (file: LevelFile, recipe: Recipe): LevelFile => {
  const level = createEditedLevel(file);
  const result = level.change('act', recipe);
  if (!result.ok) throw new Error(result.refusal.message);
  return level.file();
};

/** A level with one placed object, and that object. */
const withOne = (placeable: (typeof PLACEABLES)[number]): { file: LevelFile; found: FoundObject } => {
  const file = fileAfter(BARE, addObject(placeable, 40, 60));
  const found = [...objectsOf(file).values()].find(({ list }) => list !== null);
  if (found === undefined) throw new Error('nothing was placed');
  return { file, found };
};

/** A brush that only counts fills and strokes. */
function countingBrush(): { brush: Brush; drawn: () => number } {
  let drawn = 0;
  const set = new Map<string | symbol, unknown>();
  const gradient = { addColorStop: () => {} };
  const brush = new Proxy({} as Brush, {
    get: (_, name) => {
      if (set.has(name)) return set.get(name);
      return () => {
        if (name === 'fill' || name === 'stroke') drawn++;
        return gradient;
      };
    },
    set: (_, name, value) => {
      set.set(name, value);
      return true;
    },
  });
  return { brush, drawn: () => drawn };
}

describe.each(OBJECT_KINDS)('%s on the canvas', (kind) => {
  it('has its own textures, which draw something in both themes', () => {
    for (const [name, draw] of Object.entries(DRAWINGS[kind].textures)) {
      const owners = OBJECT_KINDS.filter((one) => Object.hasOwn(DRAWINGS[one].textures, name));
      expect(owners).toEqual([kind]);
      expect(SHARED).not.toContain(name);
      for (const theme of ['dark', 'light'] as const) {
        const { brush, drawn } = countingBrush();
        draw(brush, COLOURS[theme], theme);
        expect(drawn()).toBeGreaterThan(0);
      }
    }
  });

  it('has an icon', () => {
    for (const isVariant of [false, true]) expect(signOf(kind, isVariant).Icon).toBeDefined();
    expect(signOf(kind, true) === signOf(kind, false)).toBe(KINDS[kind].variant === undefined);
  });

  it('has the fields of the table in the inspector, with their units, limits and defaults', () => {
    const { about, fields } = fieldsOf(kind);
    expect(about).toBe(KINDS[kind].about);
    expect(fields.map(({ key, about, fallback }) => [key, about, fallback])).toEqual(
      fieldsOfKind(kind).map(([name, field]) => [name, field.about, field.default]),
    );
    for (const { key, type, unit, least, most, step } of fields) {
      const field = KINDS[kind].fields[key];
      expect(type).toBe(field.type);
      if (field.type === 'number') expect([unit, least, most, step]).toEqual([field.unit, field.least, field.most, field.step]);
    }
  });
});

describe.each(PLACEABLES)('a new %s', (placeable) => {
  const { kind, flag } = placedAs(placeable);
  const { file, found } = withOne(placeable);
  const radius = radiusOf(found) ?? 0;

  it('has its kind, is valid, is at its place, and has a tool', () => {
    expect(TOOLS).toContain(placeable);
    expect(found).toMatchObject({ kind, list: listOf(kind), object: { x: 40, y: 60 } });
    if (flag !== null) expect(found.object).toMatchObject({ [flag]: true });
    expect(readLevel(formatLevel(file)).ok).toBe(true);
  });

  it('has its places beside each other, so that each can be dragged', () => {
    const places = placesOf(found);
    expect(places).toHaveLength(KINDS[kind].places.length);
    for (const [i, place] of places.entries()) {
      expect(hitTest(file, her, place, 1, [])).toEqual({ key: found.key, place: i, part: 'body' });
      const onRim = { x: place.x, y: place.y + radius };
      expect(hitTest(file, her, onRim, 1, [found.key])).toEqual({ key: found.key, place: i, part: 'rim' });
    }
  });

  it('is selected by a marquee around any of its places, and all its places count for the level’s extent', () => {
    for (const { x, y } of placesOf(found)) {
      expect(objectsIn(file, her, { left: x - 1, top: y - 1, right: x + 1, bottom: y + 1 })).toEqual([found.key]);
      const box = extentOf(file, her, [found.key]);
      expect(box?.left).toBeLessThanOrEqual(x - radius);
      expect(box?.right).toBeGreaterThanOrEqual(x + radius);
    }
  });

  it('attracts snapping at all of its places, and one of its places can snap to another', () => {
    const others = snapTargets(file, her, []).x.map(({ at }) => at);
    for (const { x } of placesOf(found)) expect(others).toEqual(expect.arrayContaining([x - radius, x, x + radius]));
    const [, ...second] = placesOf(found);
    for (const { x } of second) {
      const targets = snapTargets(file, her, [found.key], { only: 0 });
      expect(targets.x.map(({ at }) => at)).toContain(x);
      expect(targets.own?.left).toBe(found.object.x - radius);
      expect(targets.own?.right).toBe(found.object.x + radius);
    }
  });

  it('is drawn at its place with existing textures', () => {
    const parts = ON_CANVAS[kind].parts(found);
    expect(parts.length).toBeGreaterThan(0);
    for (const { texture } of parts) expect([...Object.keys(DRAWINGS[kind].textures), ...SHARED]).toContain(texture);
    const at = parts.map(() => ({ x: Number.NaN, y: Number.NaN }));
    const images = at.map((place) => {
      const image: Figure['images'][number] = {
        scale: 1,
        setAlpha: () => {},
        setRotation: () => {},
        setPosition: (x, y) => Object.assign(place, { x, y }),
      };
      return image;
    });
    const figure: Figure = { found, at: found.object, radius, parts, images, away: parts.map(() => ({ x: 0, y: 0 })) };
    put(figure, 40, 60);
    for (const [i, { offset }] of parts.entries()) {
      expect(at[i].x).toBeCloseTo(40 + (offset?.x ?? 0) * radius, 9);
      expect(at[i].y).toBeCloseTo(60 + (offset?.y ?? 0) * radius, 9);
    }
    ON_CANVAS[kind].pose?.(figure, null, 1);
    ON_CANVAS[kind].turn?.(figure, 1, 1);
    for (const { x, y } of at) expect(Math.hypot(x - 40, y - 60)).toBeLessThan(2 * radius);
  });

  it('is listed in the outline under its kind', () => {
    const rows = objectRows(file, new Set());
    const row = rows.find(({ key }) => key === found.key);
    expect(row).toMatchObject({ title: nameOf(found), depth: 2 });
    expect(nameOf(found).toLowerCase()).toBe(`${(flag === null ? KINDS[kind] : KINDS[kind].variant)?.one} 1`);
    expect(rows.find((one) => one.depth === 1 && one.kind === kind)?.title.toLowerCase()).toBe(KINDS[kind].many);
  });

  it('can be moved as a whole, or at one place only', () => {
    const before = placesOf(found);
    const placesAfter = (recipe: Recipe) => {
      const moved = objectsOf(fileAfter(file, recipe)).get(found.key);
      if (moved === undefined) throw new Error('it is gone');
      return placesOf(moved);
    };
    expect(placesAfter(moveObjects([found.key], 7, -3))).toMatchObject(before.map(({ x, y }) => ({ x: x + 7, y: y - 3 })));
    for (const i of before.keys()) {
      const expected = before.map(({ x, y }, k) => (k === i ? { x: x + 7, y: y - 3 } : { x, y }));
      expect(placesAfter(moveObjects([found.key], 7, -3, i))).toMatchObject(expected);
    }
  });

  it('keeps both coordinates of a place together in a merge, whichever side is chosen', () => {
    for (const i of placesOf(found).keys()) {
      const mine = fileAfter(file, moveObjects([found.key], 5, 0, i));
      const theirs = fileAfter(file, moveObjects([found.key], 0, 5, i));
      const { conflicts } = mergeLevels(file, mine, theirs);
      expect(conflicts).toHaveLength(1);
      const { file: merged } = mergeLevels(file, mine, theirs, new Map([[conflicts[0].key, 'theirs']]));
      expect(merged).toEqual(theirs);
    }
    // changes by one side only are taken from both
    const mine = fileAfter(file, moveObjects([found.key], 5, 5));
    const theirs = fileAfter(file, setRadius([found.key], 99));
    const both = mergeLevels(file, mine, theirs);
    expect(both.conflicts).toEqual([]);
    expect(both.file).toEqual(fileAfter(mine, setRadius([found.key], 99)));
  });
});

describe('a wind on the canvas', () => {
  const signOfWind = (ax: number, ay: number) => {
    const file = fileAfter(withOne('wind').file, (draft) => void Object.assign(draft.winds?.[0] ?? {}, { ax, ay }));
    const [found] = [...objectsOf(file).values()].filter(({ kind }) => kind === 'wind');
    const [, sign] = ON_CANVAS.wind.parts(found);
    return sign;
  };

  it('points in its direction, is larger the stronger it is, and is always visible', () => {
    fc.assert(
      fc.property(
        fc.double({ min: 0.01, max: 100, noNaN: true }),
        fc.double({ min: -3.1, max: 3.1, noNaN: true }),
        (by, turn) => {
          const [ax, ay] = [by * Math.cos(turn), by * Math.sin(turn)];
          const { texture, rotation, scale } = signOfWind(ax, ay);
          expect(texture).toBe('streaks');
          expect(rotation).toBeCloseTo(turn, 9);
          expect(scale).toBeGreaterThanOrEqual(0.5);
          expect(scale).toBeLessThan(1);
          expect(signOfWind(2 * ax, 2 * ay).scale).toBeGreaterThanOrEqual(scale ?? 0);
        },
      ),
    );
  });

  it('has another icon without strength', () => {
    expect(signOfWind(0, 0).texture).toBe('calm');
  });
});

describe('operations on a level of any kinds', () => {
  const number = fc.oneof(fc.integer({ min: -300, max: 300 }), fc.double({ min: -1e12, max: 1e12, noNaN: true }));
  const recipeFor = (file: LevelFile, key: string, other: string, a: number, b: number): Recipe[] => {
    const keys = [key, other];
    const found = objectsOf(file).get(key);
    const names = found === undefined ? [] : fieldsOfKind(found.kind).filter(([, field]) => field.type === 'number');
    return [
      moveObjects(keys, a, b),
      moveObjects(keys, a, b, 0),
      duplicateObjects(keys, a, b),
      alignObjects(file, keys, 'left'),
      alignObjects(file, keys, 'middle'),
      distributeObjects(file, objectsOf(file).keys(), 'x'),
      setRadius(keys, a),
      scaleRadius(file, keys, b),
      reorderObject(key, 0),
      deleteObjects(keys),
      ...names.map(([name]) => setObjectProperty([key], name as FieldName, a)),
      ...PLACEABLES.map((placeable) => addObject(placeable, a, b)),
      ...PLACEABLES.map((placeable) => addObject(placeable, b, a, Math.abs(a))),
    ];
  };

  it('leave a level that reads back the same', () => {
    fc.assert(
      fc.property(arbitraryFile, fc.nat(), fc.nat(), fc.nat(), number, number, (file, i, k, n, a, b) => {
        const keys = [...objectsOf(file).keys()];
        const recipes = recipeFor(file, keys[i % keys.length], keys[k % keys.length], a, b);
        const after = fileAfter(file, recipes[n % recipes.length]);
        const reading = readLevel(formatLevel(after));
        expect(reading.ok && reading.document.file).toEqual(after);
      }),
      { numRuns: 120 },
    );
  });

  it('copy objects between levels with all their places', () => {
    fc.assert(
      fc.property(arbitraryFile, (file) => {
        const text = copyObjects(file, objectsOf(file).keys());
        if (text === null) return;
        const reading = readClipping(text);
        if (!reading.ok) throw new Error(reading.refusal.message);
        const pasted = fileAfter(BARE, pasteObjects(reading.clipping));
        for (const kind of LISTED_KINDS) {
          const list = listOf(kind);
          const placesIn = (one: LevelFile) =>
            (one[list] ?? []).map((object: FoundObject['object']) => placesOf({ kind, object }).map(({ x, y }) => [x, y]));
          expect(placesIn(pasted)).toEqual(placesIn(file));
        }
      }),
    );
  });
});
