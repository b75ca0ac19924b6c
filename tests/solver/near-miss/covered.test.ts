import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { LevelFile } from '../../../schema/index.ts';
import { type Asked, at, BOX, FRAMES, hot, levelWith, nearMisses, spot, whyNot } from './near-miss.ts';

const covered = { kind: 'covered' } as const;
const MINERAL = { kind: 'mineral', index: 0 } as const;
const hole = (radius = 18) => ({ ...spot(300, 40), radius });
const why = (more: Partial<LevelFile>, asked?: Asked) =>
  whyNot(levelWith({ blackHole: hole(), asteroids: [at(0, 100)], ...more }), covered, asked);

/** Gap of her box, turned by an angle, and a point. */
function gapTo(px: number, py: number, angle: number): number {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const along = Math.max(0, Math.abs(px * c + py * s) - BOX.halfWidth);
  const across = Math.max(0, Math.abs(py * c - px * s) - BOX.halfHeight);
  return Math.hypot(along, across);
}

/** The radius that novae need at some places about the hole so that no box touches it clear of all, by trying poses: no less than this. */
function radiusNeeded(novae: readonly (readonly [number, number])[], radius: number): number {
  let needed = 0;
  for (let i = 0; i < 60; i++) {
    const angle = (i * Math.PI) / 60;
    for (let j = 0; j < 120; j++) {
      const way = (j * Math.PI) / 60;
      // from inside outwards, to where the box leaves the hole
      let [near, far] = [0, radius + BOX.halfDiagonal];
      for (let n = 0; n < 40; n++) {
        const d = (near + far) / 2;
        if (gapTo(-d * Math.cos(way), -d * Math.sin(way), angle) < radius) near = d;
        else far = d;
      }
      const [x, y] = [near * Math.cos(way), near * Math.sin(way)];
      needed = Math.max(needed, Math.min(...novae.map(([nx, ny]) => gapTo(nx - x, ny - y, angle))));
    }
  }
  return needed;
}

describe('covered', () => {
  const not = 'she may touch it and no hazard';

  // it comes first, since it is quick: a long way from the truth few poses need to be looked at
  it('is what trying poses says, wherever novae and hot asteroids lie about the hole', () => {
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
      { numRuns: 15 },
    );
  });

  // near the truth it takes too many poses to see: that, and no bound, is most of the slack
  const coarse = { safe: 'above', says: '', reach: 2, grain: 0.05 } as const;
  nearMisses({
    'a nova about the same place': { ...coarse, why: (r) => why({ novae: [at(300, 40, r)] }), truth: 18, slack: [0.05, 0.9] },
    'a nova beside it, along x': { ...coarse, why: (r) => why({ novae: [at(304, 40, r)] }), truth: 22, slack: [0.05, 0.35] },
    'a nova beside it, along y': {
      ...coarse,
      why: (r) => why({ novae: [at(9000, 0), at(300, 35, r)] }),
      truth: 23,
      slack: [0.05, 0.35],
    },
    'two novae, of which neither covers it': {
      ...coarse,
      why: (r) => why({ novae: [at(306, 40, r), at(294, 40, r)] }),
      truth: radiusNeeded(
        [
          [6, 0],
          [-6, 0],
        ],
        18,
      ),
      slack: [0.02, 0.3],
    },
    'a hot asteroid that recoil drags': {
      ...coarse,
      why: (r) => why({ asteroids: [hot(304, 40, r)], recoil: true }, { maxTime: 20 }),
      // r - 400 / (4 r) = 22
      truth: (22 + Math.sqrt(22 * 22 + 400)) / 2,
      slack: [0.05, 0.4],
    },
    // a press may turn her into the hazard in the instant in which she touches the mineral: only where her centre can't be, it is covered
    'a mineral, wherever her centre is': {
      ...coarse,
      why: (r) =>
        why(
          { blackHole: spot(4000, 0), novae: [at(900, 0), at(300, 40, r)], minerals: [{ ...spot(300, 40), radius: 7 }] },
          { about: MINERAL },
        ),
      truth: 7 + BOX.halfDiagonal - BOX.halfWidth,
      slack: [0.02, 0.16],
    },
    'a mineral in the black hole': {
      ...coarse,
      why: (r) => why({ blackHole: hole(r), minerals: [{ ...spot(300, 40), radius: 7 }] }, { about: MINERAL }),
      truth: 7 + BOX.halfDiagonal - BOX.halfWidth,
      slack: [0.02, 0.16],
    },
    'a black hole that her corner reaches at the start': {
      why: (d) =>
        why({
          blackHole: { ...spot((10 / BOX.halfDiagonal) * d, (16 / BOX.halfDiagonal) * d), radius: 18 },
          novae: [at(20, 32, 60)],
        }),
      truth: 18 + BOX.halfDiagonal,
      safe: 'above',
      slack: [3.78e-5, 1e-3],
      says: 'she may touch it at the start',
      reach: 2,
      grain: 1e-4,
    },
  });

  it('what covers, and what does not', () => {
    const big = at(300, 40, 60);
    expect(why({ novae: [big] })).toBeNull();
    expect(why({ asteroids: [hot(300, 40, 60)] })).toBeNull();
    expect(why({ asteroids: [big] })).toBe(not);
    expect(why({ aliens: [big] })).toBe(not);
    expect(why({ repulsors: [big] })).toBe(not);
    expect(why({})).toBe(not);
    expect(why({ novae: [big] }, { covers: FRAMES })).toBe('with frames the black hole comes before hazards');
  });
});
