import * as fc from 'fast-check';
import { expect, test } from 'vitest';
import { type PathPoint, simplify } from '../../picture/way.ts';

const points = fc.array(fc.tuple(fc.double({ min: -50, max: 50, noNaN: true }), fc.double({ min: -50, max: 50, noNaN: true })), {
  minLength: 2,
  maxLength: 60,
});

function distanceToSegment([x, y]: PathPoint, [ax, ay]: PathPoint, [bx, by]: PathPoint): number {
  const length = (bx - ax) ** 2 + (by - ay) ** 2;
  const t = length === 0 ? 0 : Math.max(0, Math.min(1, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length));
  return Math.hypot(x - ax - t * (bx - ax), y - ay - t * (by - ay));
}

test('removed points lie within the tolerance of what remains, and the ends stay', () => {
  fc.assert(
    fc.property(points, fc.double({ min: 0.1, max: 20, noNaN: true }), (line, tolerance) => {
      const kept = simplify(line, tolerance);
      expect(kept[0]).toBe(line[0]);
      expect(kept.at(-1)).toBe(line.at(-1));
      for (const p of line) {
        const nearest = Math.min(...kept.slice(1).map((b, i) => distanceToSegment(p, kept[i], b)));
        expect(nearest).toBeLessThanOrEqual(tolerance + 1e-9);
      }
    }),
  );
});

test('a straight line keeps only its ends', () => {
  const line = Array.from({ length: 1000 }, (_, i): PathPoint => [i, 2 * i]);
  expect(simplify(line, 0.2)).toEqual([
    [0, 0],
    [999, 1998],
  ]);
});

test('a line of 50,000 points keeps few of them, without a stack overflow', () => {
  const line = Array.from({ length: 50_000 }, (_, i): PathPoint => [Math.cos(i / 3000) * i, Math.sin(i / 3000) * i]);
  expect(simplify(line, 1).length).toBeLessThan(5_000);
});
