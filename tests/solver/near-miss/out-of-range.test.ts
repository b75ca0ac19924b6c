import { describe, expect, it } from 'vitest';
import { compile, simulate } from '../../../engine/index.ts';
import {
  at,
  BOX,
  CONTINUOUS,
  CORNER,
  FRAMES,
  levelWith,
  type NearMiss,
  nearMisses,
  ORIGIN,
  PULL,
  RANGE,
  spot,
  TICK,
  whyNot,
} from './near-miss.ts';

const ALL = [...CONTINUOUS, ...FRAMES];
const lists = (...asteroids: number[]) => ({ kind: 'out-of-range', asteroids }) as const;
const MINERAL = { kind: 'mineral', index: 0 } as const;
/** The checker uses 18.868 px for half the diagonal of the box, 18.86796 px. */
const ROUNDED = 3.77e-5;

/**
 * How far an asteroid of a given radius gets in so many seconds if it is pulled all the time by 1 / diameter; 1 % is added for
 * frames.
 */
const recoilWay = (radius: number, seconds: number): number => (1.01 * seconds * seconds) / (2 * radius) / 2;
/** The same in frames: they go as far as one frame more, and the last may end a frame after the time. */
const framesWay = (radius: number, seconds: number): number =>
  (recoilWay(radius, 1) * (60 * seconds + 1) * (60 * seconds + 2)) / 3600;

/** What is farther from the asteroid than the range plus the reach of her box. */
const beyondRange = (place: (d: number) => { x: number; y: number }, d0 = 0): NearMiss => ({
  why: (d) => whyNot(levelWith({ asteroids: [at(100, 0)], blackHole: place(d) }), lists(0), { covers: ALL }),
  truth: d0 + RANGE + 18 + BOX.halfDiagonal,
  safe: 'above',
  slack: [ROUNDED + 1e-7, ROUNDED + 3e-7],
  says: 'she may touch it in range of asteroid 1',
});

describe('out-of-range', () => {
  nearMisses({
    'a black hole to the right': beyondRange((d) => spot(100 + d, 0)),
    'a black hole above': beyondRange((d) => spot(100, -d)),
    'a black hole behind the start': beyondRange((d) => spot(100 - 0.6 * d, 0.8 * d)),
    'a mineral': {
      why: (d) =>
        whyNot(levelWith({ asteroids: [at(100, 0)], minerals: [{ ...spot(100, d), radius: 7 }] }), lists(0), { about: MINERAL }),
      truth: RANGE + 7 + BOX.halfDiagonal,
      safe: 'above',
      slack: [ROUNDED + 1e-7, ROUNDED + 3e-7],
      says: 'she may touch it in range of asteroid 1',
    },
    'a rock that recoil drags': {
      why: (d) => {
        const level = levelWith({ asteroids: [at(100, 0, 20)], blackHole: spot(100 + d, 0), recoil: true });
        return whyNot(level, lists(0), { covers: ALL, maxTime: 30 });
      },
      truth: RANGE + 18 + BOX.halfDiagonal + framesWay(20, 30) / 1.01,
      safe: 'above',
      // 1 % of 11.27 px.
      slack: [0.1126 + ROUNDED, 0.1128 + ROUNDED],
      says: 'she may touch it in range of asteroid 1',
    },
    'a rock that is not listed, in range of the start': {
      why: (d) => whyNot(levelWith({ asteroids: [at(0, d)], blackHole: spot(5000, 0) }), lists(), { covers: ALL }),
      truth: RANGE,
      safe: 'above',
      slack: [1e-7, 2e-7],
      says: 'asteroid 1 is in range of the start and not listed',
    },
    'a rock that is not listed, and that recoil drags': {
      why: (d) => {
        const level = levelWith({ asteroids: [at(0, -d, 10)], blackHole: spot(5000, 0), recoil: true });
        return whyNot(level, lists(), { maxTime: 60 });
      },
      truth: RANGE + recoilWay(10, 60) / 1.01,
      safe: 'above',
      slack: [0.899, 0.901],
      says: 'asteroid 1 is in range of the start and not listed',
    },
    'two ranges that touch': {
      why: (d) => whyNot(levelWith({ asteroids: [at(-100, 0), at(-100, d)], blackHole: spot(5000, 0) }), lists(0)),
      truth: 2 * RANGE,
      safe: 'above',
      slack: [1e-7, 3e-7],
      says: 'asteroid 2 is not listed, and she may reach it from asteroid 1',
    },
    'two ranges that touch once recoil has dragged both': {
      why: (d) => {
        const level = levelWith({ asteroids: [at(-100, 0, 10), at(-100, d, 40)], blackHole: spot(5000, 0), recoil: true });
        return whyNot(level, lists(0), { maxTime: 20 });
      },
      truth: 2 * RANGE + (recoilWay(10, 20) + recoilWay(40, 20)) / 1.01,
      safe: 'above',
      slack: [0.124, 0.126],
      says: 'asteroid 2 is not listed, and she may reach it from asteroid 1',
    },
    'a black hole that her corner touches at the start': {
      why: (d) => whyNot(levelWith({ asteroids: [], blackHole: spot(CORNER.x * d, -CORNER.y * d) }), lists()),
      truth: 18 + BOX.halfDiagonal,
      safe: 'above',
      slack: [ROUNDED + 1e-7, ROUNDED + 2e-7],
      says: 'she may touch it at the start',
    },
  });

  it('a malformed list', () => {
    const level = levelWith({ asteroids: [at(100, 0), at(-100, 0)] });
    expect(whyNot(level, lists(0, 1))).toBeNull();
    for (const list of [[0, 2], [0, 1, -1], [0, 1, 0.5], [0, 1, '1'], 'all', null, { length: 0 }]) {
      const why = whyNot(level, { kind: 'out-of-range', asteroids: list as never });
      expect(why).toBe('it lists asteroids that the level does not have');
    }
  });

  it('with recoil it must state how long a run may last', () => {
    const level = levelWith({ asteroids: [at(100, 0)], recoil: true });
    expect(whyNot(level, lists(0))).toBe('with recoil it must say how long a run may last');
    expect(whyNot(level, lists(0), { maxTime: 60 })).toBeNull();
    expect(whyNot(level, lists(0), { maxTime: 900 })).toBe('she may touch it in range of asteroid 1');
  });
});

/**
 * The farthest that she can come between two observations of `arcade`: at the speed of the start plus what the pull adds over
 * the longest possible distance, the diagonal of the rectangle around the start and all ranges, plus one frame's flight at the
 * speed limit beyond each side.
 */
function farthestJump(v: { vx: number; vy: number }, width: number, height: number): number {
  const limit = 1.4143 * 1000 * TICK;
  const way = Math.sqrt((width + 2 * limit) ** 2 + (height + 2 * limit) ** 2);
  return Math.min(limit, 1.001 * TICK * Math.sqrt(v.vx ** 2 + v.vy ** 2 + 2 * PULL * way));
}

describe('out-of-range in frames', () => {
  /** A gap between two ranges of r px, in frames; `width` and `height` of the rectangle around the start and both ranges. */
  const gap = (
    [x, y]: readonly [number, number],
    side: readonly [number, number],
    v: { vx: number; vy: number },
    size: (d: number) => readonly [width: number, height: number],
    range = 250,
  ): NearMiss => {
    const why = (d: number) =>
      whyNot(
        levelWith({
          astronaut: { ...ORIGIN, ...v },
          asteroids: [at(x, y), at(x + side[0] * d, y + side[1] * d)],
          blackHole: spot(9e5, 0),
          range,
        }),
        lists(0),
        { covers: FRAMES },
      );
    const needs = (d: number) => 2 * range + farthestJump(v, ...size(d));
    let truth = 2 * range;
    for (let i = 0; i < 50; i++) truth = needs(truth);
    return { why, truth, safe: 'above', slack: [1e-7, 2e-4], says: 'she may reach it from asteroid 1', reach: 3 };
  };
  const v = { vx: 300, vy: -400 };
  nearMisses({
    'a gap to the right': gap([50, 0], [1, 0], v, (d) => [d + 500, 500]),
    'a gap to the left': gap([-50, 0], [-1, 0], v, (d) => [d + 500, 500]),
    'a gap above': gap([0, -50], [0, -1], v, (d) => [500, d + 500]),
    'a gap below': gap([0, 50], [0, 1], { vx: 0, vy: 0 }, (d) => [500, d + 500]),
    'a gap to the right, from a start out of all ranges': gap([300, 0], [1, 0], v, (d) => [300 + d + 250, 500]),
    'a gap above, from a start out of all ranges': gap([0, -300], [0, -1], v, (d) => [500, 300 + d + 250]),
    'small ranges': gap([5, 0], [1, 0], { vx: 50, vy: 0 }, (d) => [d + 20, 20], 10),
    'at the speed limit': gap([0, 100], [0, 1], { vx: 1000, vy: -999 }, (d) => [500, d + 500]),
  });

  // Ranges that recoil may move lengthen the distance over which she may gain speed.
  it.each([
    ['x', [1, 0]],
    ['-x', [-1, 0]],
    ['y', [0, 1]],
    ['-y', [0, -1]],
  ] as const)('recoil counts twice: it carries ranges on, and makes ways longer: %s', (_, [x, y]) => {
    const why = (d: number) =>
      whyNot(
        levelWith({
          asteroids: [at(50 * x, 50 * y, 4), at((50 + d) * x, (50 + d) * y, 4)],
          blackHole: spot(9e5, 0),
          recoil: true,
        }),
        lists(0),
        {
          covers: FRAMES,
          maxTime: 40,
        },
      );
    const drift = framesWay(4, 40);
    let truth = 500;
    for (let i = 0; i < 50; i++)
      truth = 500 + 2 * drift + farthestJump({ vx: 0, vy: 0 }, truth + 500 + 2 * drift, 500 + 2 * drift);
    expect(why(truth)).toContain('she may reach it');
    expect(why(truth + 2e-4)).toBeNull();
  });

  it('she jumps from range to range over a gap that she cannot cross in continuous time: simulated, and therefore refused', () => {
    const level = (gapWidth: number, x: number) =>
      levelWith({
        astronaut: { ...ORIGIN, vx: 600, vy: 0 },
        asteroids: [at(x, 0), at(x + 2 * RANGE + gapWidth, 0)],
        blackHole: spot(x + 2 * RANGE + 200, 0),
      });
    // 600 px/s are 10 px per frame.
    const offsets = Array.from({ length: 40 }, (_, i) => 100 + i / 4);
    const jumped = offsets.filter((x) => simulate(compile(level(9, x), 'arcade'), []).outcome === 'completed');
    expect(jumped.length).toBeGreaterThan(0);
    for (const x of offsets) {
      expect(simulate(compile(level(9, x), 'precise'), []).outcome).toBe('lost');
      expect(whyNot(level(9, x), lists(0), { covers: FRAMES })).toContain('she may reach it');
      expect(whyNot(level(9, x), lists(0))).toBeNull();
    }
  });
});
