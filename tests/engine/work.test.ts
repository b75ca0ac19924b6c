import { expect, it } from 'vitest';
import { type AccuracyName, compile, simulate, WorkBudget } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { hashedRuns } from '../browsers/scenes.ts';
import { degenerateScene } from '../scenes/degenerate-scene.ts';
import { randomScene } from '../scenes/random-scene.ts';
import { accuracyNames, continuousNames } from './accuracies.ts';
import { plainLevel } from './plain-level.ts';

// The counted cost of runs, which is the same on every machine. A change that makes runs more or less expensive shows here;
// copy the new numbers from the failure.

interface Scene {
  readonly level: Level;
  readonly holds: readonly Hold[];
  readonly maxTime: number;
}

/** Sums over scenes, by accuracy: pieces, evaluations of forces, evaluated guards, found roots, checks of the budget. */
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

it('of a third of the runs whose hashes are committed', () => {
  const third = hashedRuns().filter((_, i) => i % 3 === 0);
  const scenes = third.map(({ level, holds }) => ({ level, holds, maxTime: 60 }));
  expect(workOf(scenes, accuracyNames)).toEqual({
    arcade: '106263 31489 389719 0 446401.25',
    fast: '35663 36464 16067 376 615057',
    precise: '4053 3868 3091 389 75369',
    standard: '35664 145860 16066 376 614920',
  });
});

it('of random scenes', () => {
  expect(workOf(some(150, randomScene), continuousNames)).toEqual({
    fast: '26798 31200 30155 1302 539427',
    precise: '4150 3576 10889 1889 112362',
    standard: '26799 124804 30157 1301 539906',
  });
});

it('of scenes that depend on the last digits', () => {
  expect(workOf(some(60, degenerateScene), continuousNames)).toEqual({
    fast: '34011 45388 33972 4602 793553',
    precise: '19120 31527 24323 7632 533649',
    standard: '34452 166211 33334 4271 797783',
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
    fast: '7878 8356 6064 421 141458',
    precise: '800 785 809 440 20311',
    standard: '7884 33448 6069 425 141604',
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
    fast: '848 13048 1603 169 304082',
    precise: '439 6903 2273 308 186141',
    standard: '848 52268 1603 168 304263',
  });
});
