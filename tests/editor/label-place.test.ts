import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { labelPlace } from '../../editor/canvas/label-places.ts';

const view = { width: 800, height: 500 };
const label = { width: 200, height: 40 };
const covers = (place: { x: number; y: number }, point: { x: number; y: number }) =>
  Math.abs(place.x - point.x) < label.width / 2 && Math.abs(place.y - point.y) < label.height / 2;

describe('the place of a label', () => {
  it('is at the right of a point with nothing around', () => {
    expect(labelPlace({ x: 400, y: 250 }, label, view, [])).toEqual({ x: 516, y: 250 });
  });

  it('is below where the way comes from the left and the view ends at the right', () => {
    const way = Array.from({ length: 70 }, (_, i) => ({ x: 10 * i, y: 250 }));
    const place = labelPlace({ x: 700, y: 250 }, label, view, way);
    expect(place.y).toBe(286);
    expect(way.filter((point) => covers(place, point))).toEqual([]);
  });

  it('is in the view below the tools, does not cover a point in view, and covers no more than it would on the right', () => {
    const point = fc.record({ x: fc.integer({ min: -300, max: 1100 }), y: fc.integer({ min: -300, max: 800 }) });
    const covered = fc.array(fc.record({ x: fc.integer({ min: 0, max: 800 }), y: fc.integer({ min: 0, max: 500 }) }));
    fc.assert(
      fc.property(point, covered, (end, others) => {
        const place = labelPlace(end, label, view, others);
        expect(place.x).toBeGreaterThanOrEqual(108);
        expect(place.x).toBeLessThanOrEqual(692);
        expect(place.y).toBeGreaterThanOrEqual(76);
        expect(place.y).toBeLessThanOrEqual(472);
        const isInside = end.x > 0 && end.x < view.width && end.y > 56 && end.y < view.height;
        if (isInside) expect(covers(place, end)).toBe(false);
        const right = { x: end.x + 116, y: end.y };
        if (right.x > 692 || right.y < 76 || right.y > 472 || right.x < 108) return;
        const count = (at: typeof right) => others.filter((other) => covers(at, other)).length;
        expect(count(place)).toBeLessThanOrEqual(count(right));
      }),
    );
  });
});
