import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { boxCircleGap, compile, DEFAULT_BOX, findWarnings, simulate } from '../../engine/index.ts';
import { type LevelFile, resolveLevel } from '../../schema/index.ts';
import { continuousNames } from './accuracies.ts';

// Events that happen or fail to happen by very little, with the answer known in closed form.

const level = (more: Partial<LevelFile>) =>
  resolveLevel({
    version: 1,
    name: 'near miss',
    astronaut: { x: 0, y: 0 },
    blackHole: { x: 9000, y: 9000 },
    asteroids: [{ x: 0, y: 200, radius: 16 }],
    ...more,
  });

describe('the gap of her box and a circle', () => {
  const at = (dx: number, dy: number) => boxCircleGap(DEFAULT_BOX, dx, dy, 1, 0, 5);

  it('is that of the nearest side or corner, in all directions', () => {
    for (const [sx, sy] of [
      [1, 1],
      [-1, 1],
      [1, -1],
      [-1, -1],
    ]) {
      for (const beyond of [1e-9, 0.25, 0.5, 0.999, 1, 1.5, 20]) {
        expect(at(sx * (10 + beyond), sy * 3)).toBeCloseTo(beyond - 5, 8);
        expect(at(sx * 3, sy * (16 + beyond))).toBeCloseTo(beyond - 5, 8);
        expect(at(sx * (10 + 0.6 * beyond), sy * (16 + 0.8 * beyond))).toBeCloseTo(beyond - 5, 8);
      }
      expect(at(sx * 9.999, sy * 15.999)).toBe(-5);
    }
  });
});

describe('an alien that she flies away from', () => {
  it.each(continuousNames)('catches her on time, although she is faster at first: %s', (accuracy) => {
    const chase = fc.record({
      gap: fc.double({ min: 0.05, max: 4, noNaN: true }),
      v: fc.double({ min: 0.5, max: 6, noNaN: true }),
    });
    fc.assert(
      fc.property(chase, ({ gap, v }) => {
        // her box is 10 px to the right of her, and it drifts to the left; the gap is gap + v t - 8 t2 / 2
        const run = simulate(
          compile(level({ astronaut: { x: 0, y: 0, vx: -v, vy: 0 }, aliens: [{ x: 10 + gap + 5, y: 0, radius: 5 }] }), accuracy),
          [],
        );
        expect(run.outcome).toBe('collided');
        const time = (v + Math.sqrt(v * v + 16 * gap)) / 8;
        expect(Math.abs(run.time - time)).toBeLessThan(accuracy === 'fast' ? 1e-6 : 1e-8);
      }),
      { numRuns: 25 },
    );
  });
});

describe('the speed limit of an axis', () => {
  // she falls towards the target, and the target towards her, both along the axis with the limit
  const fall = (axis: 'x' | 'y', recoil: boolean) => {
    const [v, away] = [999, 240];
    const place = (n: number) => (axis === 'x' ? { x: n, y: 0 } : { x: 0, y: n });
    const scene = level({
      astronaut: { x: 0, y: 0, vx: axis === 'x' ? v : 0, vy: axis === 'y' ? v : 0 },
      asteroids: [{ ...place(away), radius: 0.02 }],
      recoil,
    });
    const run = simulate(compile(scene, 'precise'), [[0, 3600]], { maxTime: 0.2 });
    return { v: axis === 'x' ? run.final.vx : run.final.vy, at: axis === 'x' ? run.final.x : run.final.y };
  };
  /** The same fall in small steps: place and speed after a fifth of a second. */
  const stepped = (recoil: boolean) => {
    let [x, v, rock, u] = [0, 999, 240, 0];
    const n = 200_000;
    const h = 0.2 / n;
    const pull = () => 39 * (1 - Math.abs(rock - x) / 250) * (rock > x ? 1 : -1);
    for (let i = 0; i < n; i++) {
      const a = pull();
      const push = recoil ? (rock > x ? -25 : 25) : 0;
      x += v * h + (v < 1000 || a < 0 ? (a * h * h) / 2 : 0);
      rock += u * h + (push * h * h) / 2;
      v = Math.min(1000, v + a * h);
      u += push * h;
    }
    return { v, at: x };
  };

  it.each(['x', 'y'] as const)('is reached exactly, whether or not the target moves: %s', (axis) => {
    for (const recoil of [false, true]) {
      const [played, right] = [fall(axis, recoil), stepped(recoil)];
      expect(Math.abs(played.v - right.v)).toBeLessThan(1e-3);
      expect(Math.abs(played.at - right.at)).toBeLessThan(1e-3);
      expect(played.v).toBeLessThanOrEqual(1000);
    }
  });
});

describe('a start on the rim of a field', () => {
  // the field lies to the right and pushes her to the left with 20 px/s2
  const run = (v: number, off: number, maxTime: number) =>
    simulate(
      compile(
        level({
          astronaut: { x: 0, y: 0, vx: v, vy: 0 },
          asteroids: [{ x: -60, y: 0, radius: 16 }],
          repulsors: [{ x: 40 + off, y: 0, radius: 40 }],
        }),
      ),
      [],
      { maxTime },
    ).final;

  it.each([0, 1e-10, 1e-3])('turns her back, and she leaves as fast as she came: %f px before it', (off) => {
    const [v, time] = [6, 1];
    const inside = run(v, off, 0.3);
    expect(inside.vx).toBeCloseTo(v - 20 * (0.3 - off / v), 8);
    expect(inside.x).toBeCloseTo(v * 0.3 - 10 * (0.3 - off / v) ** 2, 8);
    const after = run(v, off, time);
    expect(after.vx).toBeCloseTo(-v, 8);
    expect(after.x).toBeCloseTo(off - v * (time - off / v - (2 * v) / 20), 7);
  });

  it('does not push her if she moves away', () => {
    const after = run(-6, 0, 1);
    expect(after.vx).toBe(-6);
    expect(after.x).toBeCloseTo(-6, 12);
  });
});

describe('warnings about objects out of reach, with recoil', () => {
  // an asteroid of radius 60 drifts 15 px in 60 s at 1 / 120 px/s2; two approach each other; a frame may jump by 23.57 px
  const rock = (x: number) => ({ x, y: 0, radius: 60 });
  const warns = (d: number, thing: number) =>
    findWarnings(level({ asteroids: [rock(0), rock(d)], blackHole: { x: d + thing, y: 0 }, recoil: true })).some(
      ({ code }) => code === 'black-hole-out-of-reach',
    );
  const jump = (Math.sqrt(2) * 1000) / 60;

  it('a gap between ranges may be wider by both drifts', () => {
    expect(warns(500 + 30 + jump - 0.1, 100)).toBe(false);
    expect(warns(500 + 30 + jump + 0.1, 100)).toBe(true);
  });

  it('an object may be farther by one drift', () => {
    const reach = 250 + 18 + DEFAULT_BOX.halfDiagonal + 15;
    expect(warns(100, reach - 0.01)).toBe(false);
    expect(warns(100, reach + 0.01)).toBe(true);
  });
});
