import * as fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { compile, simulate } from '../../engine/index.ts';
import { findWarnings, MAX_WARNINGS_PER_CODE, WARNING_CODES } from '../../engine/warnings/index.ts';
import { type Level, type LevelFile, resolveLevel } from '../../schema/index.ts';

const base: LevelFile = {
  version: 1,
  name: 'fine',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 300, y: 0 },
  asteroids: [{ x: 150, y: 0, radius: 16 }],
};
const level = (more: Partial<LevelFile>): Level => resolveLevel({ ...base, ...more });
const codes = (l: Level): string[] => findWarnings(l).map(({ code }) => code);
const hot = (x: number, y: number, radius = 16) => ({ x, y, radius, hot: true });
const cold = (x: number, y: number, radius = 16) => ({ x, y, radius });
const run = (...holds: [number, number][]) => [{ name: 'r', holds }];

// a case that each rule must report, and the most similar one that it must not report
const CASES: [code: string, pointer: string, wrong: Partial<LevelFile>, right: Partial<LevelFile>][] = [
  // 25 px down: the box ends at 16, so a nova of 16 reaches in by 7; at 32 it only touches
  ['starts-in-hazard', '/astronaut', { novae: [cold(0, 25)] }, { novae: [cold(0, 32)] }],
  ['starts-in-hazard', '/astronaut', { asteroids: [hot(25, 0)] }, { asteroids: [hot(26, 0)] }],
  ['starts-in-hazard', '/astronaut', { aliens: [{ x: -34, y: 0 }] }, { aliens: [{ x: -35, y: 0 }] }],
  ['starts-in-hazard', '/astronaut', { novae: [cold(0, 25)] }, { asteroids: [cold(0, 25)] }],
  ['touches-black-hole-at-start', '/astronaut', { blackHole: { x: 27, y: 0 } }, { blackHole: { x: 28, y: 0 } }],
  ['nothing-in-range-at-start', '/astronaut', { astronaut: { x: -101, y: 0 } }, { astronaut: { x: -100, y: 0 } }],
  ['nothing-in-range-at-start', '/astronaut', { asteroids: [] }, {}],
  // range 250 + radius 18 + half the diagonal 18.868
  ['black-hole-out-of-reach', '/blackHole', { blackHole: { x: 437, y: 0 } }, { blackHole: { x: 436, y: 0 } }],
  ['black-hole-out-of-reach', '/blackHole', { blackHole: { x: 437, y: 0 } }, { blackHole: { x: 437, y: 0 }, recoil: true }],
  // its own asteroid is no help when she can't come to it: 2 * 250 and one frame's jump of 23.6 at most between stepping stones
  [
    'black-hole-out-of-reach',
    '/blackHole',
    { blackHole: { x: 760, y: 0 }, asteroids: [cold(150, 0), cold(674, 0)] },
    { blackHole: { x: 760, y: 0 }, asteroids: [cold(150, 0), cold(650, 0)] },
  ],
  [
    'mineral-out-of-reach',
    '/minerals/1',
    {
      minerals: [
        { x: 50, y: 0 },
        { x: 150, y: 276 },
      ],
    },
    { minerals: [{ x: 150, y: 275 }] },
  ],
  ['black-hole-covered', '/blackHole', { novae: [cold(314, 0, 32)] }, { novae: [cold(315, 0, 32)] }],
  ['black-hole-covered', '/blackHole', { aliens: [{ x: 300, y: 7 }] }, { aliens: [{ x: 300, y: 8 }] }],
  [
    'black-hole-covered',
    '/blackHole',
    { asteroids: [cold(150, 0), hot(300, 0, 32)] },
    { asteroids: [cold(150, 0), cold(300, 0, 32)] },
  ],
  [
    'mineral-covered',
    '/minerals/0',
    { novae: [cold(80, 60)], minerals: [{ x: 89, y: 60 }] },
    { novae: [cold(80, 60)], minerals: [{ x: 90, y: 60 }] },
  ],
  // a target that recoil moves, or a lured alien, uncovers it
  [
    'mineral-covered',
    '/minerals/0',
    { asteroids: [hot(150, 0)], minerals: [{ x: 150, y: 0 }] },
    { recoil: true, asteroids: [hot(150, 0)], minerals: [{ x: 150, y: 0 }] },
  ],
  [
    'mineral-covered',
    '/minerals/0',
    { novae: [cold(80, 60)], minerals: [{ x: 80, y: 60 }] },
    { aliens: [{ x: 80, y: 60 }], minerals: [{ x: 80, y: 60 }] },
  ],
  [
    'aliens-explode-at-start',
    '/aliens/0',
    {
      aliens: [
        { x: 100, y: 200 },
        { x: 149, y: 200 },
      ],
    },
    {
      aliens: [
        { x: 100, y: 200 },
        { x: 150, y: 200 },
      ],
    },
  ],
  [
    'repulsor-never-acts',
    '/repulsors/1',
    { repulsors: [cold(60, 60, 48), cold(76, 60, 32)] },
    { repulsors: [cold(60, 60, 48), cold(77, 60, 32)] },
  ],
  [
    'repulsor-never-acts',
    '/repulsors/1',
    { repulsors: [cold(60, 60, 48), cold(70, 60, 32)] },
    { repulsors: [cold(70, 60, 32), cold(60, 60, 48)] },
  ],
  [
    'same-place',
    '/minerals/2',
    {
      minerals: [
        { x: 9, y: 60 },
        { x: 1, y: 60 },
        { x: 9, y: 60 },
      ],
    },
    {
      minerals: [
        { x: 9, y: 60 },
        { x: 60, y: 9 },
      ],
    },
  ],
  [
    'same-place',
    '/asteroids/1',
    { asteroids: [cold(150, 0), hot(150, 0, 32)] },
    { asteroids: [cold(150, 0)], repulsors: [cold(150, 0, 48)] },
  ],
  ['overlapping', '/novae/0', { novae: [cold(100, 99), cold(131, 99)] }, { novae: [cold(100, 99), cold(132, 99)] }],
  [
    'overlapping',
    '/asteroids/0',
    { asteroids: [cold(150, 0)], novae: [cold(181, 0)] },
    { asteroids: [cold(150, 0)], novae: [cold(182, 0)] },
  ],
  ['overlapping', '/novae/0', { novae: [cold(333, 0)] }, { novae: [cold(334, 0)] }],
  ['overlapping', '/novae/0', { novae: [cold(333, 0)] }, { repulsors: [cold(310, 0)], minerals: [{ x: 150, y: 0 }] }],
  ['holds-overlap', '/runs/0/holds/1', { runs: run([10, 20], [19, 30]) }, { runs: run([10, 20], [21, 30]) }],
  ['holds-overlap', '/runs/0/holds/1', { runs: run([10, 20], [20, 30]) }, { runs: run([10, 20], [30, 31]) }],
  ['holds-overlap', '/runs/0/holds/2', { runs: run([10, 50], [12, 13], [40, 60]) }, { runs: run([10, 50]) }],
  ['holds-unsorted', '/runs/0/holds/1', { runs: run([50, 60], [10, 20]) }, { runs: run([10, 20], [50, 60]) }],
];

describe('each rule reports its case, and nothing slightly beside it', () => {
  test.each(CASES)('%s at %s: %j, but not %j', (code, pointer, wrong, right) => {
    const found = findWarnings(level(wrong));
    expect(found.filter((w) => w.code === code).map((w) => w.pointer)).toContain(pointer);
    expect(codes(level(right))).not.toContain(code);
  });

  test('a good level has no warnings, nor has one with objects that may overlap', () => {
    expect(findWarnings(level({}))).toEqual([]);
    // awake at the start, a field over an asteroid, a mineral inside a cold one
    const busy = { aliens: [{ x: 0, y: -100 }], repulsors: [cold(150, 20, 48)], minerals: [{ x: 150, y: 5 }] };
    expect(findWarnings(level(busy))).toEqual([]);
  });

  test('every code is covered here and explained once, and its warnings contain numbers and a hint', () => {
    const told = new Set([...CASES.map(([code]) => code), 'unused-asteroid']);
    expect(new Set(WARNING_CODES.map(({ code }) => code))).toEqual(told);
    expect(WARNING_CODES.length).toBe(told.size);
    for (const [, , wrong] of CASES) {
      for (const { message, hint, severity } of findWarnings(level(wrong))) {
        expect(severity).toBe('warning');
        expect(message).toMatch(/\d|has no asteroid/);
        expect(hint).not.toBe('');
      }
    }
  });

  test('the reported distances are correct', () => {
    const [warning] = findWarnings(level({ blackHole: { x: 450, y: 0 } }));
    expect(warning.message).toContain('asteroid 1, is 300 px away');
    expect(warning.message).toContain('286.868 px');
    expect(warning.hint).toContain('13.132 px');
  });

  test('an overlap is reported once, by the most specific rule', () => {
    expect(codes(level({ novae: [cold(300, 0, 32)] }))).toEqual(['black-hole-covered']);
    expect(codes(level({ novae: [cold(100, 99), cold(100, 99)] }))).toEqual(['same-place']);
  });
});

describe('unused-asteroid', () => {
  const straight: LevelFile = { ...base, astronaut: { x: 0, y: 0, vx: 60 }, asteroids: [cold(150, 60), cold(100, -80)] };
  const simulated = (file: LevelFile, holds: [number, number][] = []) => {
    const l = resolveLevel(file);
    return findWarnings(l, [simulate(compile(l, 'arcade'), holds)]).filter(({ code }) => code === 'unused-asteroid');
  };

  test('reports an asteroid that no completing run targets', () => {
    // pressed for a moment at x = 128, where asteroid 1 is the nearest
    const found = simulated(straight, [[128, 129]]);
    expect(found.map(({ pointer }) => pointer)).toEqual(['/asteroids/1']);
  });

  test('reports nothing without runs, or if no run completes the level', () => {
    expect(findWarnings(resolveLevel(straight)).map(({ code }) => code)).not.toContain('unused-asteroid');
    expect(simulated({ ...straight, novae: [cold(200, 0)] }, [[128, 129]])).toEqual([]);
  });

  test('does not report an asteroid that keeps her in range, or a hot one', () => {
    const far = { ...straight, blackHole: { x: 700, y: 0 }, asteroids: [cold(150, 60), cold(550, 60), hot(200, -200)] };
    expect(simulated(far, [[128, 129]])).toEqual([]);
  });
});

describe('properties', () => {
  const coordinate = fc.integer({ min: -400, max: 400 });
  const radius = fc.integer({ min: 1, max: 60 });
  const circle = fc.record({ x: coordinate, y: coordinate, radius });
  const list = fc.array(circle, { maxLength: 6 });
  const levels = fc
    .record({
      astronaut: fc.record({ x: coordinate, y: coordinate }),
      blackHole: circle,
      range: fc.integer({ min: 20, max: 300 }),
      recoil: fc.boolean(),
      asteroids: fc.array(fc.record({ x: coordinate, y: coordinate, radius, hot: fc.boolean() }), { maxLength: 6 }),
      novae: list,
      repulsors: list,
      aliens: list,
      minerals: list,
    })
    .map((parts): LevelFile => ({ version: 1, name: 'any', ...parts }));

  test('moving a whole level changes nothing', () => {
    fc.assert(
      fc.property(levels, fc.integer({ min: -1e6, max: 1e6 }), fc.integer({ min: -1e6, max: 1e6 }), (file, dx, dy) => {
        const move = <T extends { x: number; y: number }>(o: T): T => ({ ...o, x: o.x + dx, y: o.y + dy });
        const moved: LevelFile = {
          ...file,
          astronaut: move(file.astronaut),
          blackHole: move(file.blackHole),
          asteroids: file.asteroids?.map(move),
          novae: file.novae?.map(move),
          repulsors: file.repulsors?.map(move),
          aliens: file.aliens?.map(move),
          minerals: file.minerals?.map(move),
        };
        expect(findWarnings(resolveLevel(moved))).toEqual(findWarnings(resolveLevel(file)));
      }),
    );
  });

  test('no run completes a level whose black hole is reported as out of reach', () => {
    const fast = fc.integer({ min: -1000, max: 1000 });
    const holds = fc.array(fc.tuple(fc.integer({ min: 0, max: 300 }), fc.integer({ min: 1, max: 200 })), { maxLength: 5 });
    fc.assert(
      fc.property(levels, fast, fast, holds, (file, vx, vy, script) => {
        const l = resolveLevel({ ...file, astronaut: { ...file.astronaut, vx, vy } });
        const scene = compile(l, 'arcade');
        const found = new Set(findWarnings(l).map(({ code, pointer }) => `${code} ${pointer}`));
        const result = simulate(
          scene,
          script.map(([press, length]) => [press, press + length] as const),
          { maxTime: 10 },
        );
        if (found.has('black-hole-out-of-reach /blackHole')) expect(result.outcome).not.toBe('completed');
        if (found.has('nothing-in-range-at-start /astronaut')) expect([result.outcome, result.time]).toEqual(['lost', 0]);
        for (const { index } of result.minerals) expect(found).not.toContain(`mineral-out-of-reach /minerals/${index}`);
      }),
      { numRuns: 150 },
    );
  });

  test('an index for many objects gives the same result', () => {
    // novae on a lattice: without the index the same neighbours overlap
    const novae = Array.from({ length: 300 }, (_, i) => cold(50 * (i % 20), 400 + 50 * Math.floor(i / 20)));
    novae[17] = cold(novae[16].x + 20, novae[16].y);
    const found = findWarnings(level({ novae })).filter(({ code }) => code === 'overlapping');
    expect(found.map(({ pointer, message }) => [pointer, message.includes('nova 18')])).toEqual([['/novae/16', true]]);
  });

  test('a level with thousands of the same mistake is reported a few times, and then that there are more', () => {
    const minerals = Array.from({ length: 5000 }, (_, i) => ({ x: 5000 + i, y: 0 }));
    const found = findWarnings(level({ minerals }));
    expect(found.length).toBe(MAX_WARNINGS_PER_CODE + 1);
    expect(found.at(-1)?.message).toContain(`only the first ${MAX_WARNINGS_PER_CODE} are listed`);
  });
});
