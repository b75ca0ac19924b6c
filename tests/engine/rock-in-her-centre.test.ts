import { expect, it } from 'vitest';
import { compile, simulate, WorkBudget } from '../../engine/index.ts';
import { randomScene } from '../scenes/random-scene.ts';
import { continuousNames } from './accuracies.ts';
import { plainLevel } from './plain-level.ts';

// In a field the gun drags its target, which may be exactly in her centre.

it.each(continuousNames)('at rest in the centre of a field, both she and the target stay there: %s', (accuracy) => {
  for (const apart of [0, 1e-300, 1e-12]) {
    const level = plainLevel({
      asteroids: [{ x: apart, y: 0, radius: 16 }],
      repulsors: [{ x: 0, y: 0, radius: 100 }],
      recoil: true,
      range: 250,
    });
    const budget = new WorkBudget();
    const run = simulate(compile(level, accuracy), [[10, 300]], { maxTime: 6, budget });
    expect(run.outcome).toBe('timeout');
    expect([run.final.x, run.final.y, run.final.vx, run.final.vy]).toEqual([0, 0, 0, 0]);
    const places = new Float64Array(2);
    run.trajectory.asteroidsAt(6, places);
    expect(Math.hypot(...places)).toBeLessThan(1e-11);
    expect(budget.spent).toBeLessThan(1000);
  }
});

it.each(continuousNames)('numbers stay finite and the work small if she also slides along a rim: %s', (accuracy) => {
  for (const seed of [30_279, 22_978, 30_909, 34_301, 209_007]) {
    const { level, holds, maxTime } = randomScene(seed);
    const budget = new WorkBudget();
    const run = simulate(compile(level, accuracy), holds, { maxTime, budget });
    const state = new Float64Array(6);
    for (let t = 0; t <= run.time; t += 1 / 60) {
      run.trajectory.at(t, state);
      if (!state.every(Number.isFinite)) expect.fail(`${state} at ${t} s`);
    }
    expect(budget.spent).toBeLessThan(20_000);
  }
});

it.each(continuousNames)(
  'work stays bounded if the target gets into her centre while she slides along a huge rim: %s',
  (accuracy) => {
    const level = plainLevel({
      range: 250,
      recoil: true,
      asteroids: [
        { x: 0, y: 1, radius: 1 },
        { x: -1e-15, y: -1, radius: 1 },
      ],
      repulsors: [{ x: 1e-13, y: -1e6, radius: 1e6 }],
    });
    const budget = new WorkBudget();
    const run = simulate(compile(level, accuracy), [[0, 180]], { maxTime: 3, budget });
    expect(run.time).toBe(3);
    expect(budget.spent).toBeLessThan(20_000);
  },
);
