import fc from 'fast-check';
import { expect, it } from 'vitest';
import { compile, simulate } from '../../engine/index.ts';
import { plainLevel } from './plain-level.ts';

const place = (from: number, to: number) => fc.double({ min: from, max: to, noNaN: true });

// a step of `standard` ends a little beside the cubic that events are found on
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
    { numRuns: 200 },
  );
  expect(switches).toBeGreaterThan(30);
});
