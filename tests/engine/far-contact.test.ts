import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, createSimulation, WorkBudget } from '../../engine/index.ts';
import { continuousNames } from './accuracies.ts';
import { plainLevel } from './plain-level.ts';

// On an endless coast, times grow so large that the steps of a march vanish in their rounding.
describe.each(continuousNames)('a contact after a million seconds is found with bounded work: %s', (accuracy) => {
  it('at any distance', () => {
    fc.assert(
      fc.property(
        fc.integer({ min: 1, max: 1000 }),
        fc.integer({ min: 1_000_000, max: 2 ** 30 }),
        fc.integer({ min: 0, max: 1000 }),
        fc.constantFrom(0, 3, 8),
        (tenths, far, thousandths, aside) => {
          const blackHole = { x: aside, y: far + thousandths / 1000, radius: 18 };
          const astronaut = { x: 0, y: 0, vx: 0, vy: tenths / 10 };
          const level = plainLevel({ astronaut, blackHole, range: 4e9, asteroids: [{ x: 5000, y: 0, radius: 16 }] });
          const budget = new WorkBudget(2000);
          const simulation = createSimulation(compile(level, accuracy), budget);
          simulation.advance(2 ** 40, false);
          expect(simulation.ending?.outcome).toBe('completed');
          const gap = blackHole.y - 16 - Math.sqrt(18 * 18 - Math.max(0, aside - 10) ** 2);
          const time = gap / astronaut.vy;
          expect(Math.abs((simulation.ending?.time ?? 0) - time)).toBeLessThan(1e-9 + 1e-14 * time);
        },
      ),
    );
  });
});
