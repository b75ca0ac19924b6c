import { describe, expect, it } from 'vitest';
import { compile, STATE_SIZE, simulate } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { continuousNames } from '../engine/accuracies.ts';
import { plainLevel } from '../engine/plain-level.ts';

/** Only whole numbers, so that shifts by whole numbers are exact. */
const LEVEL = plainLevel({
  range: 250,
  recoil: true,
  astronaut: { vx: 12, vy: -7 },
  asteroids: [
    { x: 90, y: 40, radius: 16 },
    { x: 180, y: -120, radius: 32 },
    { x: 40, y: -190, radius: 16, hot: true },
  ],
  novae: [{ x: 260, y: 60, radius: 16 }],
  repulsors: [{ x: 120, y: -40, radius: 32 }],
  aliens: [{ x: -140, y: 60, radius: 25 }],
  minerals: [{ x: 60, y: 20, radius: 7 }],
});
const HOLDS: readonly (readonly Hold[])[] = [
  [[0, 90]],
  [
    [10, 60],
    [75, 140],
  ],
  [
    [0, 31],
    [200, 260],
  ],
];

function shifted(level: Level, by: number): Level {
  const move = <T extends { x: number; y: number }>(o: T): T => ({ ...o, x: o.x + by, y: o.y - by });
  return {
    ...level,
    astronaut: move(level.astronaut),
    blackHole: move(level.blackHole),
    asteroids: level.asteroids.map(move),
    novae: level.novae.map(move),
    repulsors: level.repulsors.map(move),
    aliens: level.aliens.map(move),
    minerals: level.minerals.map(move),
  };
}

// px: half the distance of doubles at the far place is 1.2e-10 and 1.2e-7
const SHIFTS = [
  [2 ** 20, 1e-9],
  [2 ** 30, 1e-6],
] as const;

describe.each(continuousNames)('the same level far from the origin: %s', (accuracy) => {
  it.each(SHIFTS)('gives the same path after a shift by %d px', (by, within) => {
    for (const holds of HOLDS) {
      const here = simulate(compile(LEVEL, accuracy), holds, { maxTime: 20 });
      const there = simulate(compile(shifted(LEVEL, by), accuracy), holds, { maxTime: 20 });
      // only places may differ: times are equal to the last bit
      expect([there.outcome, there.with, there.time, there.events]).toEqual([here.outcome, here.with, here.time, here.events]);
      expect(here.events.length).toBeGreaterThanOrEqual(5);
      const [a, b] = [new Float64Array(STATE_SIZE), new Float64Array(STATE_SIZE)];
      for (let t = 0; t <= here.trajectory.duration; t += 0.1) {
        here.trajectory.at(t, a);
        there.trajectory.at(t, b);
        expect(Math.abs(b[0] - by - a[0])).toBeLessThanOrEqual(within);
        expect(Math.abs(b[1] + by - a[1])).toBeLessThanOrEqual(within);
      }
    }
  });
});
