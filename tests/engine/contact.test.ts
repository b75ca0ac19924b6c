import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { boxCircleGap, boxOverlapsCircle, circlesOverlap, DEFAULT_BOX } from '../../engine/index.ts';
import { expectDeep } from '../depth.ts';

/** Directions with rational cos = c / n, sin = s / n. */
const TRIANGLES = [
  [1, 0, 1],
  [3, 4, 5],
  [5, 12, 13],
  [8, 15, 17],
  [20, 21, 29],
  [119, 120, 169],
] as const;

const direction = fc
  .tuple(fc.constantFrom(...TRIANGLES), fc.boolean(), fc.boolean(), fc.boolean())
  .map(([[c, s, n], swap, left, up]) => {
    const [a, b] = swap ? [s, c] : [c, s];
    return { c: left ? -a : a, s: up ? -b : b, n };
  });

/** Fractions of 1/64 px: exact in doubles, and in integers once multiplied by 64. */
const SCALE = 64;
const sixtyFourths = (most: number) => fc.integer({ min: -most * SCALE, max: most * SCALE }).map((k) => k / SCALE);
const exact = (x: number): bigint => BigInt(x * SCALE);

/**
 * gap^2 - r^2 of box and circle in integers of (n / 64 px)^2, by definition: turn, clamp, compare. Nothing is rounded.
 * @returns the difference and r^2 in the same unit
 */
function exactBoxCircle(dx: number, dy: number, { c, s, n }: { c: number; s: number; n: number }, r: number) {
  const [x, y, cos, sin, side] = [exact(dx), exact(dy), BigInt(c), BigInt(s), BigInt(n)];
  const outside = (along: bigint, half: number) => {
    const beyond = (along < 0n ? -along : along) - exact(half) * side;
    return beyond > 0n ? beyond : 0n;
  };
  const gx = outside(x * cos + y * sin, DEFAULT_BOX.halfWidth);
  const gy = outside(y * cos - x * sin, DEFAULT_BOX.halfHeight);
  const rr = (exact(r) * side) ** 2n;
  return { difference: gx * gx + gy * gy - rr, rr };
}

const boxCase = fc.record({
  dx: sixtyFourths(80),
  dy: sixtyFourths(80),
  turn: direction,
  r: fc.integer({ min: 1, max: 50 * SCALE }).map((k) => k / SCALE),
});

/** A circle that reaches the box, or nearly: the radius is the rounded gap, plus or minus a few units of 1/64 px. */
const nearTouch = fc
  .tuple(sixtyFourths(60), sixtyFourths(60), direction, fc.integer({ min: -2, max: 2 }))
  .map(([dx, dy, turn, off]) => {
    const gap = boxCircleGap(DEFAULT_BOX, dx, dy, turn.c / turn.n, turn.s / turn.n, 0);
    return { dx, dy, turn, r: Math.max(1, Math.round(gap * SCALE) + off) / SCALE };
  });

describe('box and circle', () => {
  it('agree with exact arithmetic except within rounding, and exactly along the axes', () => {
    let touching = 0;
    fc.assert(
      fc.property(fc.oneof(boxCase, nearTouch), ({ dx, dy, turn, r }) => {
        const { difference, rr } = exactBoxCircle(dx, dy, turn, r);
        const overlaps = boxOverlapsCircle(DEFAULT_BOX, dx, dy, turn.c / turn.n, turn.s / turn.n, r);
        // 53 bits of places up to 80 px, compared with a radius down to 1/64 px
        const undecidable = turn.n !== 1 && (difference < 0n ? -difference : difference) < (rr >> 36n) + 1n;
        if (difference === 0n) touching++;
        if (!undecidable) expect(overlaps).toBe(difference < 0n);
      }),
      { numRuns: 2000 },
    );
    expectDeep(touching).toBeGreaterThan(0);
  });

  it('a touch is no contact', () => {
    expect(boxOverlapsCircle(DEFAULT_BOX, 26, 0, 1, 0, 16)).toBe(false);
    expect(boxOverlapsCircle(DEFAULT_BOX, 26 - 2 ** -40, 0, 1, 0, 16)).toBe(true);
    expect(boxOverlapsCircle(DEFAULT_BOX, 0, 32, 1, 0, 16)).toBe(false);
    expect(boxOverlapsCircle(DEFAULT_BOX, 0, 32 - 2 ** -40, 1, 0, 16)).toBe(true);
    // after a quarter turn, the short side is up
    expect(boxOverlapsCircle(DEFAULT_BOX, 0, 26, 0, 1, 16)).toBe(false);
    expect(boxOverlapsCircle(DEFAULT_BOX, 0, 31, 1, 0, 16)).toBe(true);
    expect(boxOverlapsCircle(DEFAULT_BOX, 0, 31, 0, 1, 16)).toBe(false);
    // a corner, at 3-4-5 from it
    expect(boxOverlapsCircle(DEFAULT_BOX, 13, 20, 1, 0, 5)).toBe(false);
    expect(boxOverlapsCircle(DEFAULT_BOX, 13, 20, 1, 0, 5 + 2 ** -40)).toBe(true);
  });

  it('the quick reject bounds the box', () => {
    expect(DEFAULT_BOX.halfDiagonal ** 2).toBeGreaterThan(DEFAULT_BOX.halfWidth ** 2 + DEFAULT_BOX.halfHeight ** 2);
  });

  const anyCase = fc.record({
    dx: fc.double({ min: -200, max: 200, noNaN: true }),
    dy: fc.double({ min: -200, max: 200, noNaN: true }),
    angle: fc.double({ min: -4, max: 4, noNaN: true }),
    r: fc.double({ min: 0.01, max: 120, noNaN: true }),
  });

  it('gap and overlap agree in sign', () => {
    fc.assert(
      fc.property(anyCase, ({ dx, dy, angle, r }) => {
        const gap = boxCircleGap(DEFAULT_BOX, dx, dy, Math.cos(angle), Math.sin(angle), r);
        if (Math.abs(gap) > 1e-11)
          expect(boxOverlapsCircle(DEFAULT_BOX, dx, dy, Math.cos(angle), Math.sin(angle), r)).toBe(gap < 0);
        expect(gap).toBeGreaterThanOrEqual(-r);
      }),
      { numRuns: 1200 },
    );
  });

  it('gap is the distance to the nearest of many points of the box, less the radius', () => {
    const STEPS = 64;
    fc.assert(
      fc.property(anyCase, ({ dx, dy, angle, r }) => {
        const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
        let nearest = Number.POSITIVE_INFINITY;
        for (let i = 0; i <= STEPS; i++) {
          for (let j = 0; j <= STEPS; j++) {
            const [u, v] = [DEFAULT_BOX.halfWidth * ((2 * i) / STEPS - 1), DEFAULT_BOX.halfHeight * ((2 * j) / STEPS - 1)];
            nearest = Math.min(nearest, Math.hypot(u * cos - v * sin - dx, u * sin + v * cos - dy));
          }
        }
        const spacing = Math.hypot(DEFAULT_BOX.halfWidth, DEFAULT_BOX.halfHeight) / STEPS;
        const gap = boxCircleGap(DEFAULT_BOX, dx, dy, cos, sin, r) + r;
        expect(nearest).toBeGreaterThanOrEqual(gap - 1e-9);
        expect(nearest).toBeLessThanOrEqual(gap + spacing + 1e-9);
      }),
      { numRuns: 80 },
    );
  });

  it('half turns, quarter turns of everything and mirrors change no bit', () => {
    fc.assert(
      fc.property(anyCase, ({ dx, dy, angle, r }) => {
        const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
        const images = [
          [dx, dy, -cos, -sin],
          [-dx, -dy, cos, sin],
          [-dy, dx, -sin, cos],
          [dx, -dy, cos, -sin],
          [-dx, dy, -cos, sin],
        ] as const;
        const gap = boxCircleGap(DEFAULT_BOX, dx, dy, cos, sin, r);
        const overlaps = boxOverlapsCircle(DEFAULT_BOX, dx, dy, cos, sin, r);
        for (const [x, y, c, s] of images) {
          expect(boxCircleGap(DEFAULT_BOX, x, y, c, s, r)).toBe(gap);
          expect(boxOverlapsCircle(DEFAULT_BOX, x, y, c, s, r)).toBe(overlaps);
        }
      }),
      { numRuns: 400 },
    );
  });

  it('turning box and circle together by a Pythagorean angle changes nothing', () => {
    fc.assert(
      fc.property(boxCase, fc.constantFrom(...TRIANGLES), ({ dx, dy, turn, r }, [c, s, n]) => {
        const before = boxCircleGap(DEFAULT_BOX, dx, dy, turn.c / turn.n, turn.s / turn.n, r);
        const cos = (turn.c * c - turn.s * s) / (turn.n * n);
        const sin = (turn.s * c + turn.c * s) / (turn.n * n);
        expect(boxCircleGap(DEFAULT_BOX, (dx * c - dy * s) / n, (dy * c + dx * s) / n, cos, sin, r)).toBeCloseTo(before, 10);
      }),
      { numRuns: 400 },
    );
  });
});

describe('circle and circle', () => {
  const near = fc.tuple(
    sixtyFourths(100),
    sixtyFourths(100),
    fc.integer({ min: 1, max: 100 * SCALE }).map((k) => k / SCALE),
  );
  const pythagorean = fc
    .tuple(fc.constantFrom(...TRIANGLES), fc.integer({ min: 1, max: 50 }), fc.constantFrom(-1 / SCALE, 0, 1 / SCALE))
    .map(([[c, s, n], k, off]) => [c * k, s * k, n * k + off] as const);

  it('agree with exact arithmetic, including touches', () => {
    fc.assert(
      fc.property(fc.oneof(near, pythagorean), ([dx, dy, reach]) => {
        expect(circlesOverlap(dx, dy, reach)).toBe(exact(dx) ** 2n + exact(dy) ** 2n < exact(reach) ** 2n);
      }),
      { numRuns: 2000 },
    );
    expect(circlesOverlap(30, 40, 50)).toBe(false);
    expect(circlesOverlap(30, 40, 50 + 2 ** -40)).toBe(true);
  });
});
