import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { LevelFile } from '../../../schema/index.ts';
import { type Asked, at, BOX, hot, levelWith, spot, whyNot } from './near-miss.ts';
import { radiusNeeded } from './poses.ts';

// Far from the truth few poses need to be examined, so these tests are quick; covered.test.ts comes closer to it.

const covered = { kind: 'covered' } as const;
const MINERAL = { kind: 'mineral', index: 0 } as const;
const not = 'she may touch it and no hazard';
const hole = (radius = 18) => ({ ...spot(300, 40), radius });
const why = (more: Partial<LevelFile>, asked?: Asked) =>
  whyNot(levelWith({ blackHole: hole(), asteroids: [at(0, 100)], ...more }), covered, asked);

describe('covered', () => {
  it('agrees with trying poses, wherever novae and hot asteroids lie around the black hole', () => {
    const off = fc.integer({ min: -8, max: 8 });
    const places = fc.array(fc.tuple(off, off), { minLength: 1, maxLength: 3 });
    fc.assert(
      fc.property(places, fc.integer({ min: 0, max: 3 }), (list, hotOnes) => {
        const needed = radiusNeeded(list, 18);
        const of = (radius: number) => {
          const circles = list.map(([x, y]) => ({ ...at(300 + x, 40 + y, radius), hot: true }));
          return why({ asteroids: [at(0, 100), ...circles.slice(0, hotOnes)], novae: circles.slice(hotOnes) });
        };
        expect(of(needed - 0.5)).toBe(not);
        expect(of(needed + 3)).toBeNull();
      }),
      { numRuns: 8 },
    );
  });

  it.each([
    [6, -6],
    [6, 6],
    [-6, 6],
    [-9, -4],
    [4, 9],
    [8, -3],
  ])('agrees with trying poses, for a nova displaced diagonally by %i, %i px', (x, y) => {
    const needed = radiusNeeded([[x, y]], 18);
    expect(why({ novae: [at(300 + x, 40 + y, needed - 0.1)] })).toBe(not);
    expect(why({ novae: [at(300 + x, 40 + y, needed + 2)] })).toBeNull();
  });

  // A box at half a right angle is covered long before one that is upright or level.
  it.each<[name: string, least: number, places: readonly [number, number][]]>([
    [
      'two aslant',
      18.4,
      [
        [10, 10],
        [-10, -10],
      ],
    ],
    [
      'four around it',
      11,
      [
        [10, 0],
        [0, 10],
        [-10, 0],
        [0, -10],
      ],
    ],
  ])('agrees with trying poses where the box stands at other angles than the novae: %s', (_, least, places) => {
    const needed = radiusNeeded(places, 18);
    expect(needed).toBeGreaterThan(least + 1.5);
    const of = (radius: number) => why({ novae: places.map(([x, y]) => at(300 + x, 40 + y, radius)) });
    for (const radius of [least, least + 0.5, least + 1, needed - 0.5, needed - 0.1]) expect(of(radius)).toBe(not);
    expect(of(needed + 2)).toBeNull();
  });

  it('agrees with trying poses where only boxes at a few angles fit between three novae', () => {
    const places = [
      [-15.68, -0.89],
      [0.18, 10.9],
      [15.38, -1.39],
    ] as const;
    const needed = radiusNeeded(places, 6);
    expect(needed).toBeGreaterThan(14.2);
    const of = (radius: number) => why({ blackHole: hole(6), novae: places.map(([x, y]) => at(300 + x, 40 + y, radius)) });
    for (const radius of [14.05, 14.1, 14.2]) expect(of(radius)).toBe(not);
    expect(of(needed + 0.5)).toBeNull();
  });

  const mineral = { ...spot(300, 40), radius: 7 };
  const forMineral = 7 + BOX.halfDiagonal - BOX.halfWidth;
  it.each<[name: string, truth: number, of: (radius: number) => string | null]>([
    ['a nova along x', 22, (r) => why({ novae: [at(304, 40, r)] })],
    ['a nova along y', 23, (r) => why({ novae: [at(9000, 0), at(300, 35, r)] })],
    // r - 400 / (4 r) = 22
    [
      'a hot asteroid that recoil drags',
      (22 + Math.sqrt(22 * 22 + 400)) / 2,
      (r) => why({ asteroids: [hot(304, 40, r)], recoil: true }, { maxTime: 20 }),
    ],
    [
      'a nova about a mineral',
      forMineral,
      (r) => why({ blackHole: spot(4000, 0), novae: [at(900, 0), at(300, 40, r)], minerals: [mineral] }, { about: MINERAL }),
    ],
    [
      'a nova beside a mineral',
      forMineral + 5,
      (r) => why({ blackHole: spot(4000, 0), novae: [at(303, 36, r)], minerals: [mineral] }, { about: MINERAL }),
    ],
    // Each covers the places closer than its radius plus 10 px; together they cover all but the very centre.
    [
      'a ring of novae about a mineral',
      15,
      (r) => {
        const ring = Array.from({ length: 12 }, (_, i) => (Math.PI * i) / 6);
        const novae = ring.map((angle) => at(300 + 25 * Math.cos(angle), 40 + 25 * Math.sin(angle), r));
        return why({ blackHole: spot(4000, 0), novae, minerals: [mineral] }, { about: MINERAL });
      },
    ],
    ['the black hole about a mineral', forMineral, (r) => why({ blackHole: hole(r), minerals: [mineral] }, { about: MINERAL })],
  ])('%s', (_, truth, of) => {
    expect(of(truth - 0.1)).toBe(not);
    expect(of(truth - 1)).toBe(not);
    expect(of(truth + 1)).toBeNull();
    expect(of(truth + 3)).toBeNull();
  });
});
