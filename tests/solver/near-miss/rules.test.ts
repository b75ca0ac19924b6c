import { describe } from 'vitest';
import type { LevelFile, OwnRules } from '../../../schema/index.ts';
import { at, CONTINUOUS, FRAMES, levelWith, type NearMiss, nearMisses, PULL, RANGE, spot, TICK, whyNot } from './near-miss.ts';

// Near misses of the rules: the places stay, and a rule is varied until a claim is just false. What is true follows from the
// game.

const U = { x: 0.6, y: 0.8 };
const on = (along: number, aside = 0, radius = 16) => at(along * U.x - aside * U.y, along * U.y + aside * U.x, radius);
const ruled = (rules: OwnRules, more: Partial<LevelFile>) => levelWith({ ...more, rules });
const ALL = [...CONTINUOUS, ...FRAMES];

/** She swings between two novae, 60 px behind the start and 180 px ahead, with the object beside the line. */
const swing = (rules: OwnRules, thing: { x: number; y: number }) =>
  whyNot(ruled(rules, { asteroids: [on(60)], novae: [on(-80), on(200)], blackHole: { ...thing, radius: 18 } }), {
    kind: 'line-trap',
    target: 0,
    // A box of any width is stopped at the novae's centres.
    back: { at: -80, by: { kind: 'nova', index: 0 } },
    front: { at: 200, by: { kind: 'nova', index: 1 } },
    drift: null,
  });
const TUBE = 0.01;

describe('the box', () => {
  const startsIn = (rules: OwnRules, nova: { x: number; y: number; radius: number }) =>
    whyNot(ruled(rules, { asteroids: [at(100, 0)], novae: [nova] }), {
      kind: 'starts-in-hazard',
      hazard: { kind: 'nova', index: 0 },
    });
  const outOfRange = (rules: OwnRules, far: number) =>
    whyNot(
      ruled(rules, { asteroids: [at(100, 0)], blackHole: { ...spot(100 - far, 0), radius: 18 } }),
      { kind: 'out-of-range', asteroids: [0] },
      { covers: ALL },
    );
  const cases: Record<string, NearMiss> = {
    'width, a nova ahead of the start': {
      why: (n) => startsIn({ boxWidth: n }, at(40, 0, 20)),
      truth: 40,
      safe: 'above',
      slack: [0, 1e-5],
      says: 'the hazard it names does not touch her at the start',
    },
    'height, a nova above the start': {
      why: (n) => startsIn({ boxHeight: n }, at(0, -50, 20)),
      truth: 60,
      safe: 'above',
      slack: [0, 1e-5],
      says: 'the hazard it names does not touch her at the start',
    },
    'height, the thing beside the line': {
      why: (n) => swing({ boxHeight: n }, on(60, 60)),
      truth: 84,
      safe: 'below',
      slack: [2 * 2 * TUBE - 1e-6, 2 * 2 * TUBE + 1e-5],
      says: 'she may touch it on the stretch',
    },
    'diagonal, the thing just out of range': {
      why: (n) => outOfRange({ boxWidth: 30, boxHeight: n }, RANGE + 18 + 25),
      truth: 40,
      safe: 'below',
      // Half the diagonal is rounded up to a thousandth.
      slack: [0, 0.01],
      says: 'she may touch it in range of asteroid 1',
    },
  };
  nearMisses(cases);
});

describe('pull and speed limit', () => {
  /** She falls 3000 px along a slanted line from the middle of the range, as fast as the pull makes her. */
  const fastest = (pull: number) => Math.sqrt(2 * pull * 3000);
  const falls = (rules: OwnRules) =>
    whyNot(
      ruled(rules, { range: 1e5, asteroids: [on(50_000)], novae: [on(3000 + 26 - 10, 0, 16)], blackHole: spot(-500, 4000) }),
      {
        kind: 'line-trap',
        target: 0,
        back: { at: 0, by: { kind: 'start' } },
        front: { at: 3000, by: { kind: 'nova', index: 0 } },
        drift: null,
      },
    );
  nearMisses({
    'a limit that a fall may come to, at the strongest pull': {
      why: (n) => falls({ speedLimit: n }),
      truth: fastest(PULL),
      safe: 'above',
      slack: [0.001 * fastest(PULL), 0.011 * fastest(PULL)],
      says: 'she may reach the speed limit',
      reach: 10,
    },
    'a pull that takes her to the limit': {
      why: (n) => falls({ pull: n, speedLimit: 500 }),
      truth: (500 * 500) / 6000,
      safe: 'below',
      slack: [0.1, 1],
      says: 'she may reach the speed limit',
      reach: 2,
    },
  });

  /** Two asteroids so far apart that a frame's flight must be longer than the gap between their ranges. */
  const hop = (rules: OwnRules, gap: number) =>
    whyNot(
      ruled(rules, {
        range: 1e4,
        astronaut: { ...spot(0, 0), vx: 1000, vy: 1000 },
        asteroids: [at(0, 0), at(2e4 + gap, 0)],
        blackHole: spot(-3e4, 0),
      }),
      { kind: 'out-of-range', asteroids: [0] },
      { covers: FRAMES },
    );
  nearMisses({
    'a limit that lets a frame leap over a gap': {
      why: (n) => hop({ speedLimit: n }, 10),
      truth: 10 / (Math.SQRT2 * TICK),
      safe: 'below',
      slack: [0.02, 0.03],
      says: 'and she may reach it from',
    },
  });
});

describe('recoil', () => {
  const SECONDS = 10;
  /** An asteroid that is pulled for so long takes its range along. */
  const drifts = (recoil: number) =>
    whyNot(
      ruled({ recoil }, { recoil: true, asteroids: [at(0, 0, 5)], blackHole: { ...spot(RANGE + 40 + 25, 0), radius: 5 } }),
      { kind: 'out-of-range', asteroids: [0] },
      { maxTime: SECONDS },
    );
  // What the box leaves of 60 px, at recoil / 10 px per s².
  const left = 60 - 18.868;
  nearMisses({
    'a recoil that brings the range to the thing': {
      why: drifts,
      truth: (left * 20) / (SECONDS * SECONDS),
      safe: 'below',
      slack: [0, (0.011 * left * 20) / (SECONDS * SECONDS)],
      says: 'she may touch it in range of asteroid 1',
      reach: 2,
    },
  });
});
