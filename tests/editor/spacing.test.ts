import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { equalSpacing, snapMove, snapTargets } from '../../editor/canvas/snapping.ts';
import type { Box } from '../../editor/canvas/view.ts';
import { boxOf } from '../../engine/index.ts';
import { DEFAULT_RULES, type LevelFile } from '../../schema/index.ts';
import { expectDeep } from '../depth.ts';

const box = fc
  .tuple(
    fc.integer({ min: -300, max: 300 }),
    fc.integer({ min: -60, max: 60 }),
    fc.integer({ min: 4, max: 60 }),
    fc.integer({ min: 4, max: 60 }),
  )
  .map(([left, top, width, height]): Box => ({ left, top, right: left + width, bottom: top + height }));

describe('equal spacing', () => {
  it('moves no farther than the reach, and the gaps that it reports are equal and free', () => {
    let count = 0;
    fc.assert(
      fc.property(box, fc.array(box, { maxLength: 8 }), fc.constantFrom('x' as const, 'y' as const), (own, boxes, axis) => {
        const spacing = equalSpacing(own, boxes, axis, 20);
        if (spacing === null) return;
        count++;
        expect(Math.abs(spacing.by)).toBeLessThanOrEqual(20);
        const [first, second] = spacing.gaps;
        expect(second.to - second.from).toBeCloseTo(first.to - first.from, 9);
        const moved = {
          low: (axis === 'x' ? own.left : own.top) + spacing.by,
          high: (axis === 'x' ? own.right : own.bottom) + spacing.by,
        };
        // one end of a gap at least is an edge of what moves
        expect(spacing.gaps.some(({ from, to }) => Math.abs(to - moved.low) < 1e-9 || Math.abs(from - moved.high) < 1e-9)).toBe(
          true,
        );
        for (const { from, to } of spacing.gaps) expect(to - from).toBeGreaterThanOrEqual(1);
      }),
      { numRuns: 500 },
    );
    expectDeep(count).toBeGreaterThan(20);
  });

  it('stands between two neighbours or in a row with them, and says how large the gaps are', () => {
    const rocks = (...xs: number[]): LevelFile => ({
      version: 1,
      name: 'Row',
      astronaut: { x: 0, y: 900 },
      blackHole: { x: 0, y: 1500 },
      asteroids: xs.map((x, i) => ({ id: `a${i}`, x, y: 100, radius: 16 })),
    });
    const drag = (file: LevelFile, id: string, move: { x: number; y: number }) => {
      const lead = file.asteroids?.find((one) => one.id === id) ?? { x: 0, y: 0 };
      const targets = snapTargets(file, boxOf(DEFAULT_RULES), [id]);
      return snapMove(lead, move, targets, { grid: 8, toObjects: true, reach: 5 });
    };
    // between 100 and 300: the middle is 200, whatever the grid
    const between = drag(rocks(100, 301, 190), 'a2', { x: 8, y: 0 });
    expect(190 + between.dx).toBe(200.5);
    expect(between.measures.map(({ words }) => words)).toEqual(['68.5 px', '68.5 px']);
    // in a row: 100, 160, and so 220
    const row = drag(rocks(100, 160, 400), 'a2', { x: -177, y: 0 });
    expect(400 + row.dx).toBe(220);
    expect(row.measures.map(({ words }) => words)).toEqual(['28 px', '28 px']);
    expect(row.guides).toContainEqual({ axis: 'y', at: 100, from: 116, to: 144 });
    // too far away: the grid
    expect(400 + drag(rocks(100, 160, 400), 'a2', { x: -100, y: 0 }).dx).toBe(304);
  });
});
