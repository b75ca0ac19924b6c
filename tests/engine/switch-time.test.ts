import fc from 'fast-check';
import { expect, it } from 'vitest';
import { compile, simulate, WorkBudget } from '../../engine/index.ts';
import { expectDeep } from '../depth.ts';
import { continuousNames } from './accuracies.ts';
import { plainLevel } from './plain-level.ts';

const place = (from: number, to: number) => fc.double({ min: from, max: to, noNaN: true });

// a step of `standard` ends slightly beside the cubic on which events are found
it.each([
  ['fast', 1e-12],
  ['standard', 1e-6],
  ['precise', 1e-12],
] as const)('a target changes where two asteroids are equally far: %s, to %s px', (accuracy, error) => {
  let switches = 0;
  const scene = fc.record({
    start: fc.record({ x: place(-150, 0), y: place(-80, 80), vx: place(20, 120), vy: place(-20, 20) }),
    other: fc.record({ x: place(60, 250), y: place(-100, 100) }),
    own: fc.record({ x: place(-160, -40), y: place(60, 160) }),
    recoil: fc.boolean(),
  });
  fc.assert(
    fc.property(scene, ({ start, other, own, recoil }) => {
      const level = plainLevel({
        astronaut: start,
        asteroids: [
          { ...own, radius: 16 },
          { ...other, radius: 16 },
        ],
        range: 500,
        recoil,
      });
      const run = simulate(compile(level, accuracy), [[0, 240]], { maxTime: 4 });
      const at = new Float64Array(6);
      const rocks = new Float64Array(4);
      for (const event of run.events) {
        if (event.type !== 'target' || event.time === 0) continue;
        switches++;
        run.trajectory.at(event.time, at);
        run.trajectory.asteroidsAt(event.time, rocks);
        const [first, second] = [0, 2].map((o) => Math.hypot(rocks[o] - at[0], rocks[o + 1] - at[1]));
        expect(Math.abs(first - second)).toBeLessThan(error);
      }
    }),
    { numRuns: 80 },
  );
  expectDeep(switches).toBeGreaterThan(12);
});

// held along one axis, then along the other, she comes back to the tie whichever of the two the target is
it.each(continuousNames)('the target changes a bounded number of times at the speed limit: %s', (accuracy) => {
  for (const [apart, along, recoil] of [
    [50, 90, false],
    [77, 40, true],
    [77, 90, true],
    [120, 20, true],
    [25, 75, false],
  ] as const) {
    for (const side of [1, -1]) {
      const level = plainLevel({
        astronaut: { x: 0, y: 0, vx: 1000, vy: side * 1000 },
        asteroids: [
          { x: along + apart, y: side * (along - apart), radius: 16 },
          { x: along - apart, y: side * (along + apart), radius: 16 },
        ],
        range: 400,
        recoil,
      });
      for (const holds of [
        [[0, 300]],
        [
          [3, 9],
          [12, 40],
          [41, 300],
        ],
      ] as const) {
        const budget = new WorkBudget();
        const run = simulate(compile(level, accuracy), holds, { maxTime: 5, budget });
        expect(run.stopped).toBeNull();
        expect(run.events.filter(({ type }) => type === 'target').length).toBeLessThan(30);
        expect(budget.spent).toBeLessThan(5000);
      }
    }
  }
});
