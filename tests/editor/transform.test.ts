import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { selectionBox } from '../../editor/canvas/extent.ts';
import { handleAt, handlesOf, scalingOf } from '../../editor/canvas/selection-handles.ts';
import {
  createEditedLevel,
  groupsIn,
  mapObjects,
  mapProblem,
  mirrorAlong,
  objectsOf,
  placesOf,
  type Recipe,
  radiusOf,
  repeatObjects,
  scaleObjects,
  turnBy,
} from '../../editor/core/document/index.ts';
import { boxOf } from '../../engine/index.ts';
import { DEFAULT_RULES, KINDS, type LevelFile } from '../../schema/index.ts';
import { arbitraryFile } from './arbitrary-file.ts';

const HER = boxOf(DEFAULT_RULES);

type Numbers = Readonly<Record<string, number | undefined>>;

/** Every number of an object that a turn changes: its places and vectors, with the defaults of those that are left out. */
function movedNumbers(file: LevelFile): number[][] {
  return [...objectsOf(file).values()].map((found) => {
    const numbers = found.object as unknown as Numbers;
    const usual = (name: string) => {
      const field = KINDS[found.kind].fields[name];
      return field.type === 'number' ? (field.default ?? 0) : 0;
    };
    const vectors = Object.values(KINDS[found.kind].vectors as Readonly<Record<string, readonly string[]>>).flat();
    return [...placesOf(found).flatMap(({ x, y }) => [x, y]), ...vectors.map((name) => numbers[name] ?? usual(name))];
  });
}

const changed = (file: LevelFile, ...recipes: readonly Recipe[]): LevelFile => {
  const level = createEditedLevel(file);
  for (const recipe of recipes) expect(level.change('change', recipe).ok).toBe(true);
  return level.file();
};

/** Whether all numbers differ by no more than `apart`. */
function expectClose(now: readonly number[][], then: readonly number[][], apart: number): void {
  for (const [i, numbers] of now.entries())
    for (const [k, number] of numbers.entries()) expect(Math.abs(number - then[i][k])).toBeLessThanOrEqual(apart);
}

/** Levels whose places are near 0, so that rounding to 0.01 is not lost among the digits of a place a billion px away. */
const near = arbitraryFile.filter((file) =>
  [...objectsOf(file).values()].every((found) => placesOf(found).every(({ x, y }) => Math.abs(x) < 1e5 && Math.abs(y) < 1e5)),
);
const degrees = fc.oneof(fc.constantFrom(90, 180, 270, -90, 45, 15, 1), fc.double({ min: -360, max: 360, noNaN: true }));
const centre = fc.record({ x: fc.integer({ min: -400, max: 400 }), y: fc.integer({ min: -400, max: 400 }) });
const axis = fc.constantFrom('x' as const, 'y' as const);
const keysOf = (file: LevelFile) => [...objectsOf(file).keys()];

describe('turning objects', () => {
  it('and back is no change but for rounding, with the winds and velocities', () => {
    fc.assert(
      fc.property(near, degrees, centre, (file, angle, about) => {
        const [keys, there, back] = [keysOf(file), turnBy(angle), turnBy(-angle)];
        fc.pre(mapProblem(file, keys, there) === null);
        const turned = changed(file, mapObjects(keys, about, there));
        const now = changed(turned, mapObjects(keys, about, back));
        // half a grain each way, turned, and that of a number that was not rounded before
        expectClose(movedNumbers(now), movedNumbers(file), 0.0126);
      }),
    );
  });

  it('keeps distances, and is exact by quarters', () => {
    fc.assert(
      fc.property(near, degrees, centre, (file, angle, about) => {
        const keys = keysOf(file);
        fc.pre(mapProblem(file, keys, turnBy(angle)) === null);
        const turned = changed(file, mapObjects(keys, about, turnBy(angle)));
        const objects = objectsOf(turned);
        for (const found of objectsOf(file).values()) {
          const then = placesOf(found);
          const now = placesOf(objects.get(found.key) ?? found);
          for (const [i, { x, y }] of now.entries()) {
            const before = Math.hypot(then[i].x - about.x, then[i].y - about.y);
            expect(Math.abs(Math.hypot(x - about.x, y - about.y) - before)).toBeLessThanOrEqual(0.0072);
          }
        }
      }),
    );
    const level = (x: number, y: number, ax: number, ay: number) =>
      ({
        version: 1,
        name: 'Winds',
        astronaut: { x: 0, y: 0, vx: 10, vy: 0 },
        blackHole: { x: 9, y: 9 },
        winds: [{ id: 'ww', x, y, radius: 9, ax, ay }],
        wormholes: [{ id: 'oo', x: 10, y: 0, toX: 20, toY: 0, radius: 9 }],
      }) as LevelFile;
    const turned = changed(level(10, 0, 0, -20), mapObjects(['ww', 'oo', '@astronaut'], { x: 0, y: 0 }, turnBy(90)));
    expect(turned.winds).toEqual([{ id: 'ww', x: 0, y: 10, radius: 9, ax: 20, ay: 0 }]);
    expect(turned.wormholes).toEqual([{ id: 'oo', x: 0, y: 10, toX: 0, toY: 20, radius: 9 }]);
    expect(turned.astronaut).toEqual({ x: 0, y: 0, vx: 0, vy: 10 });
    expect(turned.blackHole).toEqual({ x: 9, y: 9 });
    // the default of a wind turns, too: it blows upwards
    const usual = { ...level(0, 0, 0, 0), winds: [{ id: 'ww', x: 0, y: 0, radius: 9 }] };
    expect(changed(usual, mapObjects(['ww'], { x: 0, y: 0 }, turnBy(180))).winds).toEqual([
      { id: 'ww', x: 0, y: 0, radius: 9, ay: 20 },
    ]);
    // what would be too strong along an axis is refused, not weakened
    expect(mapProblem(level(0, 0, 100, 100), ['ww'], turnBy(45))).toBe(
      'Wind 1 would have wind y 141.42 px/s2; 100 is the most. Make it weaker first.',
    );
    expect(mapProblem(level(0, 0, 100, 100), ['ww'], turnBy(90))).toBe(null);
  });
});

describe('mirroring objects', () => {
  it('twice is no change but for rounding, and once keeps what lies on the axis', () => {
    fc.assert(
      fc.property(near, axis, centre, (file, along, about) => {
        const keys = keysOf(file);
        const once = changed(file, mapObjects(keys, about, mirrorAlong(along)));
        expectClose(movedNumbers(changed(once, mapObjects(keys, about, mirrorAlong(along)))), movedNumbers(file), 0.0101);
        for (const [key, found] of objectsOf(once)) {
          const old = objectsOf(file).get(key)?.object ?? found.object;
          expect(Math.abs(found.object[along] + old[along] - 2 * about[along])).toBeLessThanOrEqual(0.0051);
        }
      }),
    );
  });
});

describe('scaling objects', () => {
  it('by a factor and its inverse is no change but for rounding; radii follow only if asked', () => {
    fc.assert(
      fc.property(near, fc.constantFrom(0.5, 2, 4), centre, fc.boolean(), (file, factor, from, withRadii) => {
        const keys = keysOf(file);
        const by = (f: number) => ({ from, x: f, y: f, radii: withRadii ? f : 1 });
        const scaled = changed(file, scaleObjects(file, keys, by(factor)));
        const back = changed(scaled, scaleObjects(scaled, keys, by(1 / factor)));
        const places = (one: LevelFile) =>
          [...objectsOf(one).values()].map((found) => placesOf(found).flatMap(({ x, y }) => [x, y]));
        expectClose(places(back), places(file), 0.0051 * (1 + Math.max(1, 1 / factor)));
        for (const [key, found] of objectsOf(scaled)) {
          const old = radiusOf(objectsOf(file).get(key) ?? found);
          const now = radiusOf(found);
          if (old === null || now === null) expect(now).toBe(old);
          else if (!withRadii) expect(now).toBe(old);
          else expect(Math.abs(now - Math.min(1e6, Math.max(1e-3, old * factor)))).toBeLessThanOrEqual(0.0051);
        }
      }),
    );
  });

  it('by a handle keeps the opposite side and lets the dragged one follow the pointer', () => {
    const file: LevelFile = {
      version: 1,
      name: 'Three',
      astronaut: { x: 900, y: 900 },
      blackHole: { x: 950, y: 950 },
      asteroids: [
        { id: 'aa', x: 100, y: 100, radius: 16 },
        { id: 'bb', x: 300, y: 100, radius: 16 },
        { id: 'cc', x: 200, y: 200, radius: 16 },
      ],
    };
    const box = selectionBox(file, HER, ['aa', 'bb', 'cc']);
    if (box === null) throw new Error('several objects have a box');
    expect(box.box).toEqual({ left: 84, top: 84, right: 316, bottom: 216 });
    const dragged = (across: -1 | 0 | 1, along: -1 | 0 | 1, x: number, y: number, how: { shift?: boolean; alt?: boolean } = {}) =>
      scaleObjects(
        file,
        box.keys,
        scalingOf(
          box,
          { does: 'scale', across, along },
          { move: { x, y }, keepsShape: how.shift !== true, withRadii: how.alt === true },
        ),
      );
    const numbers = (recipe: Recipe) => changed(file, recipe).asteroids?.map(({ x, y, radius }) => [x, y, radius]);
    // an edge: one axis, radii stay
    expect(numbers(dragged(1, 0, 100, 50))).toEqual([[100, 100, 16], [400, 100, 16], [250, 200, 16]]); // biome-ignore format: a row each
    expect(numbers(dragged(-1, 0, -100, 0))).toEqual([[0, 100, 16], [300, 100, 16], [150, 200, 16]]); // biome-ignore format: a row each
    // a corner keeps the shape, with Shift it does not
    expect(numbers(dragged(1, 1, 200, 100))).toEqual([[100, 100, 16], [500, 100, 16], [300, 300, 16]]); // biome-ignore format: a row each
    expect(numbers(dragged(1, 1, 200, 0, { shift: true }))).toEqual([[100, 100, 16], [500, 100, 16], [300, 200, 16]]); // biome-ignore format: a row each
    // with Alt the radii follow, and so does the rim of the outermost
    const grown = changed(file, dragged(1, 1, 232, 132, { alt: true }));
    expect(grown.asteroids?.map(({ radius }) => radius)).toEqual([32, 32, 32]);
    expect(selectionBox(grown, HER, ['aa', 'bb', 'cc'])?.box).toEqual({ left: 84, top: 84, right: 548, bottom: 348 });
    // it never turns inside out
    for (const [x] of numbers(dragged(1, 0, -9999, 0)) ?? []) expect(x).toBeGreaterThanOrEqual(100);
    // every handle is found where it is drawn
    for (const zoom of [0.3, 1, 4]) {
      const view = { x: 0, y: 0, zoom, width: 800, height: 600 };
      for (const { handle, at } of handlesOf(box, view)) expect(handleAt(box, at, view, 'mouse')).toEqual(handle);
    }
  });

  it('has the handle that turns it above, and below where the tools of the canvas cover it', () => {
    const points = [
      { id: 'aa', x: 100, y: 100, radius: 16 },
      { id: 'bb', x: 300, y: 100, radius: 16 },
    ];
    const file = { version: 1, name: 'Box', astronaut: { x: 0, y: 0 }, blackHole: { x: 90, y: 0 }, asteroids: points } as const;
    const box = selectionBox(file as never, HER, ['aa', 'bb']);
    if (box === null) throw new Error('two objects have a box');
    const turnAt = (y: number, height: number) =>
      handlesOf(box, { x: 200, y, zoom: 1, width: 800, height }).find(({ handle }) => handle.does === 'turn')?.at;
    // 26 px of screen from the box, which is 14 px from the objects
    expect(turnAt(100, 600)).toEqual({ x: 200, y: 44 });
    expect(turnAt(300, 600)).toEqual({ x: 200, y: 156 });
    // nothing is better if it would leave the canvas below
    expect(turnAt(100, 90)).toEqual({ x: 200, y: 44 });
  });

  it('has no box for one round object, and none for what is locked', () => {
    const file = {
      version: 1,
      name: 'Marks',
      astronaut: { x: 0, y: 0 },
      blackHole: { x: 90, y: 0 },
      asteroids: [
        { id: 'aa', x: 100, y: 100, radius: 16 },
        { id: 'bb', x: 200, y: 100, radius: 16, 'x-locked': true } as never,
        { id: 'cc', x: 300, y: 100, radius: 16 },
      ],
      winds: [{ id: 'ww', x: 0, y: 0, radius: 9, ax: 1 }],
    } as LevelFile;
    expect(selectionBox(file, HER, ['aa'])).toBe(null);
    expect(selectionBox(file, HER, ['@astronaut'])).toBe(null);
    expect(selectionBox(file, HER, ['aa', 'bb'])).toBe(null);
    expect(selectionBox(file, HER, ['aa', 'bb', 'cc'])?.keys).toEqual(['aa', 'cc']);
    expect(selectionBox(file, HER, ['ww'])).toMatchObject({ keys: ['ww'], scales: false });
  });
});

describe('repeating objects', () => {
  const file = {
    version: 1,
    name: 'Repeat',
    astronaut: { x: 0, y: 0 },
    blackHole: { x: 90, y: 0 },
    asteroids: [
      { id: 'aa', x: 100, y: 0, radius: 16, 'x-group': 'pair' } as never,
      { id: 'bb', x: 100, y: 50, radius: 8, 'x-group': 'pair' } as never,
    ],
    winds: [{ id: 'ww', x: 0, y: 40, radius: 9, ax: 0, ay: -10 }],
  } as LevelFile;

  it('along a line moves each copy a step further, and each copy of a group is a group', () => {
    const now = changed(file, repeatObjects(['aa', 'bb'], { along: 'line', copies: 2, dx: 30, dy: -10 }));
    expect(now.asteroids?.map(({ x, y }) => [x, y])).toEqual([[100, 0], [100, 50], [130, -10], [130, 40], [160, -20], [160, 30]]); // biome-ignore format: places
    expect([...groupsIn(now)].map(([name, keys]) => [name, keys.length])).toEqual([
      ['pair', 2],
      ['pair 2', 2],
      ['pair 3', 2],
    ]);
    expect(new Set(now.asteroids?.map(({ id }) => id)).size).toBe(6);
  });

  it('around a centre spreads them evenly over a whole circle, or up to an angle, and turns what has a direction', () => {
    const round = (copies: number, angle: number) =>
      changed(file, repeatObjects(['ww'], { along: 'circle', copies, centre: { x: 0, y: 0 }, degrees: angle })).winds;
    expect(round(3, 360)?.map(({ x, y, ax, ay }) => [x, y, ax, ay])).toEqual([
      [0, 40, 0, -10],
      [-40, 0, 10, 0],
      [0, -40, 0, 10],
      [40, 0, -10, 0],
    ]);
    expect(round(2, 180)?.map(({ x, y }) => [x, y])).toEqual([[0, 40], [-40, 0], [0, -40]]); // biome-ignore format: places
    expect(round(1, -90)?.at(-1)).toMatchObject({ x: 40, y: 0 });
  });

  it('of more objects than a level may have is refused', () => {
    const full = { ...file, minerals: Array.from({ length: 19_900 }, (_, i) => ({ id: `m${i}`, x: i, y: 900 })) };
    const level = createEditedLevel(full as LevelFile);
    const keys = (level.file().minerals ?? []).slice(0, 10).flatMap(({ id }) => id ?? []);
    const result = level.change('Repeat', repeatObjects(keys, { along: 'line', copies: 500, dx: 1, dy: 0 }));
    expect(result.ok).toBe(false);
    expect(level.file().minerals).toHaveLength(19_900);
  });
});
