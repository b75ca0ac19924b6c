import { expect, it } from 'vitest';
import { degenerateScene } from '../../bench/soak/degenerate-scene.ts';
import { randomScene } from '../../bench/soak/random-scene.ts';
import { type AccuracyName, compile, simulate, WorkBudget } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { hashedRuns } from '../browsers/scenes.ts';
import { accuracyNames, continuousNames } from './accuracies.ts';
import { plainLevel } from './plain-level.ts';

// What runs cost, counted: the same on every machine. A change that makes them dearer, or cheaper, shows here, and what is new is taken over from the failure.

interface Scene {
  readonly level: Level;
  readonly holds: readonly Hold[];
  readonly maxTime: number;
}

/** Sums over scenes, by accuracy: pieces, evaluations of forces, guards looked at, roots found, looks of the budget. */
function workOf(scenes: readonly Scene[], accuracies: readonly AccuracyName[]): Record<string, string> {
  return Object.fromEntries(
    accuracies.map((accuracy) => {
      const sums = [0, 0, 0, 0, 0];
      for (const { level, holds, maxTime } of scenes) {
        const budget = new WorkBudget(2000);
        const { work } = simulate(compile(level, accuracy), holds, { maxTime, budget });
        for (const [i, n] of [work.pieces, work.forceEvaluations, work.guards, work.roots, budget.looks].entries()) sums[i] += n;
      }
      return [accuracy, sums.join(' ')];
    }),
  );
}

const some = (count: number, scene: (seed: number) => Scene): Scene[] => Array.from({ length: count }, (_, i) => scene(i));

it('of the runs whose hashes are committed', () => {
  const scenes = hashedRuns().map(({ level, holds }) => ({ level, holds, maxTime: 60 }));
  expect(workOf(scenes, accuracyNames)).toEqual({
    arcade: '290527 93293 1084653 0 1237667.875',
    fast: '104378 108626 44161 1338 1822763',
    precise: '11731 11219 11235 1436 227432',
    standard: '104379 434528 44160 1338 1822547',
  });
});

it('of random scenes', () => {
  expect(workOf(some(150, randomScene), continuousNames)).toEqual({
    fast: '26797 31199 32722 1313 545036',
    precise: '4150 3576 14672 1900 120286',
    standard: '26799 124804 32724 1312 545439',
  });
});

it('of scenes in which a digit decides', () => {
  expect(workOf(some(150, degenerateScene), continuousNames)).toEqual({
    fast: '79365 99625 87453 13688 1798581',
    precise: '48598 76436 64990 18444 1351571',
    standard: '80377 378198 86528 12933 1816398',
  });
});

it('of slides along a rim', () => {
  const scenes = some(40, (i) => {
    const angle = 0.37 * i;
    const radius = 30 + 9 * i;
    const level = plainLevel({
      range: 250,
      recoil: i % 4 === 0,
      astronaut: { x: -radius * Math.cos(angle), y: radius * Math.sin(angle), vx: i % 3, vy: (7 * i) % 15 },
      asteroids: [{ x: 70, y: 11, radius: i % 8 === 0 ? 0.3 : 16 }],
      repulsors: [{ x: 0, y: 0, radius }, ...(i % 5 === 0 ? [{ x: -radius, y: radius, radius: 40 }] : [])],
    });
    return { level, holds: [[3 * (i % 2), 300]] as const, maxTime: 6 };
  });
  expect(workOf(scenes, continuousNames)).toEqual({
    fast: '7883 8352 6144 432 141703',
    precise: '805 781 896 447 20516',
    standard: '7889 33432 6150 436 141850',
  });
});

it('of crowds', () => {
  const scenes = some(30, (i) => {
    const asteroids = Array.from({ length: i % 3 === 0 ? 150 : 20 }, (_, k) => ({
      x: 60 * (k % 14) - 390,
      y: 60 * Math.floor(k / 14) - 390,
      radius: 2,
    }));
    const aliens = Array.from({ length: 10 * (1 + (i % 20)) }, (_, k) => {
      const far = 90 + 3 * k + i;
      return { x: far * Math.cos(2.4 * k), y: far * Math.sin(2.4 * k), radius: 1 + ((k + i) % 7) };
    });
    const minerals = Array.from({ length: i % 2 === 0 ? 140 : 5 }, (_, k) => ({
      x: 31 * (k % 12) - 180,
      y: 37 * (k % 11),
      radius: 3,
    }));
    const level = plainLevel({
      ...{ range: 200, recoil: i % 2 === 1, asteroids, aliens, minerals },
      astronaut: { x: 3, y: 8, vx: 40 + 3 * i, vy: 31 - i },
    });
    return { level, holds: [[2, 20 + i] as const, [60, 90] as const, [120, 400] as const], maxTime: 8 };
  });
  expect(workOf(scenes, continuousNames)).toEqual({
    fast: '843 12968 1596 168 305783',
    precise: '439 6903 2276 308 191300',
    standard: '843 51948 1596 167 305972',
  });
});
