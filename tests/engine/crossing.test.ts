import fc from 'fast-check';
import { expect, test } from 'vitest';
import { crossing } from '../../engine/events/roots.ts';

/** Guards that fall below 0 only at `root`. */
const SHAPES: Record<string, (root: number, scale: number) => (t: number) => number> = {
  straight: (root, scale) => (t) => scale * (root - t),
  'bent up': (root, scale) => (t) => scale * (root - t) * (1 + scale * Math.abs(root - t)),
  'a graze but for its end': (root, scale) => (t) => scale * (root - t) * Math.abs(root - t),
  flat: (root, scale) => (t) => scale * (root - t) ** 3,
  steep: (root, scale) => (t) => scale * Math.cbrt(root - t),
  'a wall': (root, scale) => (t) => Math.tanh(1e6 * scale * (root - t)),
  'a jump': (root, scale) => (t) => (t < root ? scale : -1e-9),
  'all but 0 before': (root, scale) => (t) => (t < root ? 1e-300 : -scale),
};

const scales = fc.double({ min: -6, max: 6, noNaN: true }).map((power) => 10 ** power);

for (const [name, shape] of Object.entries(SHAPES)) {
  test(`a crossing is found to the last digits: ${name}`, () => {
    fc.assert(
      fc.property(
        fc.double({ min: 0, max: 10, noNaN: true }),
        fc.double({ min: 1e-12, max: 10, noNaN: true }),
        fc.double({ min: 0, max: 1, noNaN: true }),
        scales,
        (before, width, share, scale) => {
          const behind = before + width;
          const guard = shape(before + share * width, scale);
          fc.pre(guard(before) >= 0 && guard(behind) < 0);
          let looks = 0;
          const t = crossing(before, behind, (time) => {
            looks++;
            return guard(time);
          });
          expect(guard(t)).toBeLessThan(0);
          const digit = Math.max(1e-18, 3e-16 * t);
          if (t - digit > before) expect(guard(t - digit)).toBeGreaterThanOrEqual(0);
          expect(t).toBeLessThanOrEqual(behind);
          expect(looks).toBeLessThan(240);
        },
      ),
    );
  });
}

test('a smooth crossing takes a few evaluations', () => {
  fc.assert(
    fc.property(
      fc.double({ min: 0.01, max: 1, noNaN: true }),
      scales,
      fc.double({ min: -0.5, max: 0.5, noNaN: true }),
      (root, scale, bend) => {
        let looks = 0;
        crossing(0, 2 * root, (t) => {
          looks++;
          return scale * (root - t) * (1 + bend * (root - t));
        });
        expect(looks).toBeLessThanOrEqual(14);
      },
    ),
  );
});

test('a guard that is 0 and falls at once crosses there', () => {
  const t = crossing(0, 1e-3, (time) => -time);
  expect(t).toBeGreaterThan(0);
  expect(t).toBeLessThan(1e-18);
});
