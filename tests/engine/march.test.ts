import fc from 'fast-check';
import { expect, it } from 'vitest';
import { safeStep, safeStretch } from '../../engine/events/roots.ts';
import { compile, simulate, WorkBudget } from '../../engine/index.ts';
import { expectDeep } from '../depth.ts';
import { randomScene } from '../scenes/random-scene.ts';
import { continuousNames } from './accuracies.ts';

const real = (min: number, max: number) => fc.double({ min, max, noNaN: true });
const at = (c: Float64Array, t: number) => c.reduceRight((value, ck) => value * t + ck, 0);

it('a safe step skips no root of a polynomial, whatever else bends it down', () => {
  let whole = 0;
  fc.assert(
    fc.property(
      fc.array(real(-10, 10), { minLength: 3, maxLength: 9 }),
      real(0, 5),
      real(0, 3),
      real(0.01, 2),
      (list, value, bend, longest) => {
        const c = new Float64Array(list);
        c[0] = value;
        const stretch = safeStretch(c, c.length - 1, value, c[1], bend, longest);
        expect(stretch).toBeGreaterThanOrEqual(0);
        expect(stretch).toBeLessThanOrEqual(longest);
        if (stretch === longest) whole++;
        for (let k = 1; k <= 64; k++) {
          const t = (k / 64) * stretch;
          expect(at(c, t) - (bend * t * t) / 2).toBeGreaterThanOrEqual(-1e-9);
        }
      },
    ),
  );
  expectDeep(whole).toBeGreaterThan(10);
});

it('a polynomial that rises from 0 takes one step', () => {
  expect(safeStretch(new Float64Array([0, 0, 1.5, -1, 0.5]), 4, 0, 0, 0, 1)).toBe(1);
  expect(safeStretch(new Float64Array([0, 0, 1.5, -2]), 3, 0, 0, 0, 1)).toBe(0.5);
});

it('a step is safe and not 0 even if the product under the root underflows', () => {
  expect(safeStep(1e-200, 0, 1e-200)).toBeCloseTo(Math.SQRT2, 12);
  expect(safeStep(1e-200, 0, 0)).toBe(Number.POSITIVE_INFINITY);
});

it('fields and asteroids at the same place, one of them dragged away, take bounded work', () => {
  const { level, holds, maxTime } = randomScene(67_997);
  for (const accuracy of continuousNames) {
    const budget = new WorkBudget();
    simulate(compile(level, accuracy), holds, { budget, maxTime });
    expect(budget.spent).toBeLessThan(5000);
  }
});
