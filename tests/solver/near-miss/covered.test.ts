import { describe, expect, it } from 'vitest';
import type { LevelFile } from '../../../schema/index.ts';
import { type Asked, at, BOX, FRAMES, hot, levelWith, nearMisses, spot, whyNot } from './near-miss.ts';
import { radiusNeeded } from './poses.ts';

const covered = { kind: 'covered' } as const;
const MINERAL = { kind: 'mineral', index: 0 } as const;
const hole = (radius = 18) => ({ ...spot(300, 40), radius });
const why = (more: Partial<LevelFile>, asked?: Asked) =>
  whyNot(levelWith({ blackHole: hole(), asteroids: [at(0, 100)], ...more }), covered, asked);

describe('covered', () => {
  const not = 'she may touch it and no hazard';

  // Close to the truth too many poses would have to be examined. That makes up most of the slack, not a bound.
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
    // A press may turn her into the hazard at the instant in which she touches the mineral, so it is covered only where her
    // centre cannot be.
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
    expect(why({ novae: [big] }, { covers: FRAMES })).toBe('with frames the black hole is tested before hazards');
  });
});
