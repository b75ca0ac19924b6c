import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { createEditedLevel, normalize, type Recipe } from '../../editor/core/document/index.ts';
import { formatLevel, type LevelFile, LIMITS, OBJECT_LISTS, readLevel } from '../../schema/index.ts';
import { arbitraryFile } from './arbitrary-file.ts';

const PLAIN: LevelFile = { version: 1, name: 'plain', astronaut: { x: 0, y: 0 }, blackHole: { x: 300, y: 0 } };

const normalized = (file: object, before: LevelFile | null = null): LevelFile => {
  const result = normalize(file as LevelFile, before);
  if (!result.ok) throw new Error(result.refusal.message);
  return result.file;
};
const refused = (file: object): string => {
  const result = normalize(file as LevelFile, null);
  if (result.ok) throw new Error('was not refused');
  return result.refusal.message;
};
const ids = (file: LevelFile) => OBJECT_LISTS.flatMap((list) => (file[list] ?? []).map(({ id }) => id));

describe('the result of a recipe', () => {
  it('is completely the same object if there is nothing to fix', () => {
    fc.assert(
      fc.property(arbitraryFile, (file) => {
        for (const before of [null, structuredClone(file), file]) {
          const now = normalized(file, before);
          expect(now).toStrictEqual(file);
          for (const list of OBJECT_LISTS)
            for (const [i, object] of (file[list] ?? []).entries()) expect(now[list]?.[i]).toBe(object);
          for (const [i, run] of (file.runs ?? []).entries()) expect(now.runs?.[i]).toBe(run);
        }
      }),
    );
  });

  it('is not mutated', () => {
    const file = Object.freeze({
      ...PLAIN,
      range: 1e9,
      astronaut: Object.freeze({ x: 1e12, y: 0 }),
      novae: Object.freeze([Object.freeze({ x: 1, y: 2, radius: 0 }), Object.freeze({ x: 1, y: 2, radius: 0 })]),
      runs: Object.freeze([Object.freeze({ name: 'n', holds: Object.freeze([Object.freeze([2.5, 9])]) })]),
    });
    expect(normalized(file)).toMatchObject({
      range: LIMITS.radius,
      astronaut: { x: LIMITS.coordinate },
      runs: [{ holds: [[3, 9]] }],
    });
  });

  it('has every number clamped to its limits, and 0 for -0', () => {
    const number = fc.oneof(
      fc.double({ noNaN: true }),
      fc.double({ min: -2e9, max: 2e9, noNaN: true }),
      fc.double({ min: -2000, max: 2000, noNaN: true }),
      fc.constantFrom(0, -0, Infinity, -Infinity),
    );
    const within = (value: number, [least, most]: readonly [number, number]) => Math.min(most, Math.max(least, value)) + 0;
    const [place, speed, size] = [
      [-LIMITS.coordinate, LIMITS.coordinate],
      [-LIMITS.velocity, LIMITS.velocity],
      [LIMITS.leastRadius, LIMITS.radius],
    ] as const;
    fc.assert(
      fc.property(number, number, number, (a, b, c) => {
        const file = {
          ...PLAIN,
          range: c,
          astronaut: { x: a, y: b, vx: b, vy: c },
          novae: [{ id: 'aa', x: a, y: b, radius: c }],
        };
        const now = normalized(file);
        expect(now).toStrictEqual({
          ...PLAIN,
          range: within(c, size),
          astronaut: { x: within(a, place), y: within(b, place), vx: within(b, speed), vy: within(c, speed) },
          novae: [{ id: 'aa', x: within(a, place), y: within(b, place), radius: within(c, size) }],
        });
        // with or without the previous state
        expect(normalized(file, now)).toStrictEqual(now);
      }),
    );
  });

  it('has texts cut to their limit, without splitting a character', () => {
    const cases = [
      ['name', 120],
      ['description', 2000],
    ] as const;
    for (const [key, most] of cases) {
      const text = (length: number, end: string) => 'n'.repeat(length) + end;
      expect(normalized({ ...PLAIN, [key]: text(most, '') })[key]).toBe(text(most, ''));
      expect(normalized({ ...PLAIN, [key]: text(most, 'nn') })[key]).toBe(text(most, ''));
      expect(normalized({ ...PLAIN, [key]: text(most - 2, '🚀') })[key]).toBe(text(most - 2, '🚀'));
      expect(normalized({ ...PLAIN, [key]: text(most - 1, '🚀') })[key]).toBe(text(most - 1, ''));
      // the first and last high surrogates, and their neighbours
      for (const [unit, length] of [
        ['\ud800', most - 1],
        ['\udbff', most - 1],
        ['\ud7ff', most],
        ['\udc00', most],
      ] as const)
        expect(normalized({ ...PLAIN, [key]: text(most - 1, `${unit}nn`) })[key]?.length).toBe(length);
    }
    const run = { name: 'r'.repeat(90), holds: [] };
    expect(normalized({ ...PLAIN, runs: [run] }).runs?.[0].name).toBe('r'.repeat(80));
  });

  it('has no keys with undefined, and unchanged keys of other programs', () => {
    const file = { ...PLAIN, range: undefined, 'x-own': [Number.NaN], astronaut: { x: 0, y: 0, vx: undefined, 'x-a': 'b' } };
    expect(normalized(file)).toStrictEqual({ ...PLAIN, 'x-own': [Number.NaN], astronaut: { x: 0, y: 0, 'x-a': 'b' } });
    expect(Object.keys(normalized({ ...PLAIN, novae: undefined, runs: undefined }))).toEqual(Object.keys(PLAIN));
  });

  it('has holds with whole ticks within the hour that end after they begin', () => {
    const tick = fc.oneof(
      fc.integer({ min: -5, max: 30 }),
      fc.double({ min: -5, max: 30, noNaN: true }),
      fc.constantFrom(-0, LIMITS.tick - 1, LIMITS.tick, LIMITS.tick + 1, Infinity, -Infinity),
    );
    const near = (value: number) => Math.min(LIMITS.tick, Math.max(0, Math.round(value))) + 0;
    fc.assert(
      fc.property(
        fc.array(
          fc.tuple(tick, tick).filter(([a, b]) => !Number.isNaN(a + b)),
          { maxLength: 4 },
        ),
        (holds) => {
          const expected = holds
            .map(([press, release]) => [near(press), near(release)])
            .filter(([press, release]) => release > press);
          expect(normalized({ ...PLAIN, runs: [{ name: 'run', holds }] }).runs).toStrictEqual([{ name: 'run', holds: expected }]);
        },
      ),
    );
    for (const hold of [
      [Number.NaN, 5],
      [5, Number.NaN],
      [Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY],
    ])
      expect(refused({ ...PLAIN, runs: [{ name: 'run', holds: [hold] }] })).toContain('not begin and end at a number');
  });

  it('has a unique id on every object: of two equal ids, the first object keeps its id', () => {
    const rock = (id: unknown, x: number) => ({ id, x, y: 0, radius: 16 });
    const file = {
      ...PLAIN,
      asteroids: [rock('aa', 1), rock('aa', 2), rock('B!', 3), rock(undefined, 4), rock(7, 5), { x: 6, y: 0, radius: 16 }],
      novae: [rock('aa', 7), rock('bb', 8)],
    };
    const now = normalized(file);
    expect(now.asteroids?.[0].id).toBe('aa');
    expect(now.novae?.[1].id).toBe('bb');
    expect(new Set(ids(now)).size).toBe(8);
    for (const id of ids(now)) expect(id).toMatch(/^[a-z0-9]{2,16}$/);
    expect(readLevel(formatLevel(now)).ok).toBe(true);
    // with the previous state
    const recipes: Recipe[] = [
      (draft) => void draft.asteroids?.push(rock('aa', 9) as never),
      (draft) => void draft.asteroids?.splice(1, 1),
      (draft) => void delete draft.asteroids?.[2].id,
      (draft) => void draft.asteroids?.reverse(),
      (draft) => void Object.assign(draft.novae?.[0] ?? {}, { id: 'aa' }),
      (draft) => void Object.assign(draft.novae?.[0] ?? {}, { id: draft.novae?.[1].id }),
      (draft) => void delete draft.novae,
    ];
    for (const recipe of recipes) {
      const level = createEditedLevel(now);
      const result = level.change('act', recipe);
      expect(result.ok).toBe(true);
      expect(new Set(ids(level.file())).size).toBe(ids(level.file()).length);
      for (const id of ids(level.file())) expect(id).toMatch(/^[a-z0-9]{2,16}$/);
      expect(level.file().asteroids?.some(({ id }) => id === 'aa')).toBe(true);
    }
  });
});

describe('values without a close valid level are refused', () => {
  const hold = [1, 2];
  it.each<[message: string, more: object]>([
    ['version 1', { version: 2 }],
    ['a level needs a name', { name: '' }],
    ['a level needs a name', { name: 7 }],
    ['a level has no colour', { colour: 'red' }],
    ['recoil of a level', { recoil: 'yes' }],
    ['range of a level', { range: '7' }],
    ['range of a level would not be a number', { range: Number.NaN }],
    ['the astronaut has no x', { astronaut: { y: 1 } }],
    ['the astronaut has no y', { astronaut: { x: 1, y: undefined } }],
    ['y of the astronaut', { astronaut: { x: 1, y: null } }],
    ['the black hole has no x', { blackHole: { y: 1 } }],
    ['one of the novae has no radius', { novae: [{ x: 1, y: 2 }] }],
    ['radius of one of the aliens', { aliens: [{ x: 1, y: 2, radius: '7' }] }],
    ['one of the minerals has no hot', { minerals: [{ x: 1, y: 2, hot: true }] }],
    ['a run needs a name', { runs: [{ name: '', holds: [] }] }],
    ['a run has no colour', { runs: [{ name: 'a', holds: [], colour: 'red' }] }],
    ['a run called "a" already', { runs: ['b', 'a', 'a'].map((name) => ({ name, holds: [] })) }],
    ['20000 asteroids at most', { asteroids: Array(LIMITS.objects + 1).fill({ x: 1, y: 2, radius: 3 }) }],
    ['1000 runs at most', { runs: Array.from({ length: LIMITS.runs + 1 }, (_, i) => ({ name: `${i}`, holds: [] })) }],
    ['20000 holds at most', { runs: [{ name: 'a', holds: Array(LIMITS.holds + 1).fill(hold) }] }],
  ])('%s', (message, more) => {
    expect(refused({ ...PLAIN, ...more })).toContain(message);
  });

  it('but not as many entries as the format allows', () => {
    const full = {
      ...PLAIN,
      novae: Array.from({ length: LIMITS.objects }, (_, i) => ({ id: `n${i}`, x: i, y: 2, radius: 3 })),
      runs: Array.from({ length: LIMITS.runs }, (_, i) => ({
        name: `${i}`,
        holds: i === 0 ? Array(LIMITS.holds).fill(hold) : [],
      })),
    };
    expect(normalized(full)).toStrictEqual(full);
  });

  it('and not replaced by the previous valid value', () => {
    const before = normalized({ ...PLAIN, novae: [{ id: 'aa', x: 1, y: 2, radius: 3 }] });
    for (const novae of [
      [{ id: 'aa', x: Number.NaN, y: 2, radius: 3 }],
      [{ id: 'aa', x: 1, y: 2 }],
      [{ id: 'aa', x: 1, y: 2, radius: undefined }],
      [...(before.novae ?? []), { id: 'bb', x: 1, y: 2 }],
    ])
      expect(normalize({ ...before, novae } as LevelFile, before).ok).toBe(false);
    expect(normalize({ ...before, runs: [{ name: '', holds: [] }] }, before).ok).toBe(false);
    expect(normalize({ ...before, astronaut: { x: 1 } } as LevelFile, before).ok).toBe(false);
    expect(normalize({ ...before, blackHole: { x: 1 } } as LevelFile, before).ok).toBe(false);
  });

  it('an exception in a recipe is no refusal', () => {
    expect(() => normalize({ ...PLAIN, astronaut: null } as never, null)).toThrow(TypeError);
    expect(() => createEditedLevel({ ...PLAIN, name: '' })).toThrow(/not a valid level: a level needs a name/);
  });
});
