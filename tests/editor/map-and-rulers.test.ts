import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  type Box,
  fromMap,
  isAllInView,
  mapViewOf,
  stepFor,
  ticksOf,
  toScreen,
  type View,
  ZOOM_LIMITS,
} from '../../editor/canvas/view.ts';

const zoom = fc.double({ min: ZOOM_LIMITS.least, max: ZOOM_LIMITS.most, noNaN: true });
const from = fc.integer({ min: -100_000, max: 100_000 });

describe('rulers', () => {
  it('have round numbers with room for them, at their places, at every zoom', () => {
    fc.assert(
      fc.property(zoom, from, fc.integer({ min: 50, max: 2000 }), (by, start, length) => {
        const step = stepFor(by);
        expect(step * by).toBeGreaterThanOrEqual(64 - 1e-9);
        expect([1, 2, 5]).toContain(Number(String(step).replaceAll('0', '')));
        const ticks = ticksOf(start, length, by);
        const long = ticks.filter(({ isLong }) => isLong);
        expect(long.length).toBeLessThanOrEqual(length / 64 + 1);
        for (const { value, at } of ticks) {
          expect(at).toBeGreaterThanOrEqual(-1e-6);
          expect(at).toBeLessThanOrEqual(length + 1e-6);
          expect(start + at / by).toBeCloseTo(value, 4);
        }
        for (const { value } of long) expect(Math.abs(value / step - Math.round(value / step))).toBeLessThan(1e-9);
      }),
    );
  });
});

describe('the minimap', () => {
  const box = fc
    .tuple(from, from, fc.integer({ min: 1, max: 50_000 }), fc.integer({ min: 1, max: 50_000 }))
    .map(([left, top, width, height]): Box => ({ left, top, right: left + width, bottom: top + height }));

  it('shows the level completely, and its points lead back to the level', () => {
    fc.assert(
      fc.property(box, (all) => {
        const map = mapViewOf(all, 168, 112);
        const onMap = (x: number, y: number) => ({ x: 84 + (x - map.x) * map.scale, y: 56 + (y - map.y) * map.scale });
        for (const [x, y] of [
          [all.left, all.top],
          [all.right, all.bottom],
        ]) {
          const at = onMap(x, y);
          expect(at.x >= 0 && at.x <= 168 && at.y >= 0 && at.y <= 112).toBe(true);
          expect(fromMap(map, at, 168, 112).x).toBeCloseTo(x, 4);
          expect(fromMap(map, at, 168, 112).y).toBeCloseTo(y, 4);
        }
      }),
    );
  });

  it('is needed exactly where a corner of the level is out of view', () => {
    fc.assert(
      fc.property(box, from, from, zoom, (all, x, y, by) => {
        const view: View = { x, y, zoom: by, width: 800, height: 600 };
        const corners = [
          { x: all.left, y: all.top },
          { x: all.right, y: all.bottom },
        ].map((corner) => toScreen(view, corner));
        const isSeen = corners.every((at) => at.x >= 0 && at.x <= 800 && at.y >= 0 && at.y <= 600);
        expect(isAllInView(all, view)).toBe(isSeen);
      }),
    );
  });
});
