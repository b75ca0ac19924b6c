import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { LevelFile } from '../../../schema/index.ts';
import type { BarrierEdge, Blocker } from '../../../solver/index.ts';
import { expectDeep } from '../../depth.ts';
import { type Asked, at, BOX, CONTINUOUS, FRAMES, hot, levelWith, nearMisses, ORIGIN, RANGE, spot, whyNot } from './near-miss.ts';

const ALL = [...CONTINUOUS, ...FRAMES];
const ROUNDED = 3.77e-5;
const MINERAL = { kind: 'mineral', index: 0 } as const;
const nova = (index: number): Blocker => ({ kind: 'nova', index });
const range: Blocker = { kind: 'range' };

type Corner = readonly [x: number, y: number, by: Blocker];
const barrier = (...corners: Corner[]) => ({
  kind: 'enclosed' as const,
  barrier: corners.map(([x, y, by]): BarrierEdge => ({ ...spot(x, y), by })),
});
/** A square with this half side around a place, all of whose edges are claimed to be out of range. */
const square = (x: number, y: number, half: number, by = range) =>
  barrier([x - half, y - half, by], [x + half, y - half, by], [x + half, y + half, by], [x - half, y + half, by]);

/** Around the start with half side 100, by one large nova per side, which contains both ends of its edge. */
const FOUR = [at(0, -600, 600), at(600, 0, 600), at(0, 600, 600), at(-600, 0, 600)];
const pen = (more: Partial<LevelFile> = {}) =>
  levelWith({ novae: FOUR, asteroids: [at(0, 20)], blackHole: spot(400, 0), ...more });
const walls = (half: number) =>
  barrier([-half, -half, nova(0)], [half, -half, nova(1)], [half, half, nova(2)], [-half, half, nova(3)]);

/** How far a frame can take her from rest in a level whose rectangle of ranges has this width and height. */
const jumpOf = (width: number, height: number, speed = 0): number => {
  const limit = (1.4143 * 1000) / 60;
  return Math.min(limit, (1.001 * Math.sqrt(speed ** 2 + 2 * 39 * Math.hypot(width + 2 * limit, height + 2 * limit))) / 60);
};

describe('enclosed', () => {
  it('a pen holds, and one edge that is not blocked opens it', () => {
    expect(whyNot(pen(), walls(100))).toBeNull();
    for (const i of [0, 1, 2, 3]) {
      const novae = FOUR.filter((_, n) => n !== i);
      expect(whyNot(pen({ novae }), walls(100))).toContain('the barrier: ');
    }
  });

  /** The top edge from a to b, with a nova of 40 px between them. */
  const topEdge = (a: number, b: number, asked?: Asked) =>
    whyNot(
      pen({ novae: [...FOUR, at(0, -100, 40)] }),
      barrier(
        [-100, -100, nova(0)],
        [a, -100, nova(4)],
        [b, -100, nova(0)],
        [100, -100, nova(1)],
        [100, 100, nova(2)],
        [-100, 100, nova(3)],
      ),
      asked,
    );
  const frames = jumpOf(500, 500);
  nearMisses({
    'the first end of an edge leaves the hazard': {
      why: (n) => topEdge(-n, 20),
      truth: 40 + BOX.halfWidth,
      safe: 'below',
      slack: [1e-7, 1.2e-7],
      says: 'edge 2 of the barrier: it leaves the hazard it names',
    },
    'the second end of an edge leaves the hazard': {
      why: (n) => topEdge(-20, n),
      truth: 40 + BOX.halfWidth,
      safe: 'below',
      slack: [1e-7, 1.2e-7],
      says: 'edge 2 of the barrier: it leaves the hazard it names',
    },
    'with frames an edge is no nearer to the rim than a chord of a jump': {
      why: (n) => topEdge(-n, 20, { covers: FRAMES }),
      truth: Math.sqrt(50 * 50 - (frames / 2) ** 2),
      safe: 'below',
      slack: [1e-7, 2e-7],
      says: 'edge 2 of the barrier: it leaves the hazard it names',
    },
    'a hazard that is smaller than a jump': {
      // At the speed limit a frame takes her 23.57 px; half of that is more than a nova of 1.7 px plus the circle in her box.
      why: (r) =>
        whyNot(
          pen({ astronaut: { ...ORIGIN, vx: 1000, vy: 0 }, novae: [...FOUR, at(0, -100, r)] }),
          barrier(
            [-100, -100, nova(0)],
            [-1e-3, -100, nova(4)],
            [1e-3, -100, nova(0)],
            [100, -100, nova(1)],
            [100, 100, nova(2)],
            [-100, 100, nova(3)],
          ),
          { covers: FRAMES },
        ),
      truth:
        (1.001 * Math.sqrt(1000 ** 2 + 78 * Math.hypot(500 + 2 * 23.571666666666665, 500 + 2 * 23.571666666666665))) / 60 / 2 -
        10,
      safe: 'above',
      slack: [1e-7, 1e-6],
      says: '',
      reach: 1,
    },
    'the thing as near to an edge as her corner reaches': {
      why: (d) => whyNot(pen({ blackHole: spot(100 + d, 0) }), walls(100), { covers: CONTINUOUS }),
      truth: 18 + BOX.halfDiagonal,
      safe: 'above',
      slack: [ROUNDED + 1e-7, ROUNDED + 1.5e-7],
      says: 'she may touch it from edge 2 of the barrier',
    },
    'the thing beyond a corner': {
      why: (d) => whyNot(pen({ blackHole: spot(100 + 0.6 * d, 100 + 0.8 * d) }), walls(100)),
      truth: 18 + BOX.halfDiagonal,
      safe: 'above',
      slack: [ROUNDED + 1e-7, ROUNDED + 1.5e-7],
      says: 'she may touch it from edge 2 of the barrier',
    },
    'the thing beyond the other end of an edge': {
      why: (d) => whyNot(pen({ blackHole: spot(-100 - 0.8 * d, -100 - 0.6 * d) }), walls(100)),
      truth: 18 + BOX.halfDiagonal,
      safe: 'above',
      slack: [ROUNDED + 1e-7, ROUNDED + 1.5e-7],
      says: 'she may touch it from edge 1 of the barrier',
    },
    'with frames the thing a jump farther': {
      why: (d) => whyNot(pen({ blackHole: spot(0, -100 - d) }), walls(90), { covers: FRAMES }),
      truth: 18 + BOX.halfDiagonal + jumpOf(500, 500) - 10,
      safe: 'above',
      slack: [ROUNDED + 1e-7, ROUNDED + 1.5e-7],
      says: 'she may touch it from edge 1 of the barrier',
      reach: 1,
    },
    'a rock in range of an edge': {
      why: (d) => whyNot(levelWith({ asteroids: [at(0, 20), at(600, 100 + d)], blackHole: spot(600, 0) }), square(600, 0, 100)),
      truth: RANGE,
      safe: 'above',
      slack: [1e-7, 2e-7],
      says: 'edge 3 of the barrier: it is in range of asteroid 2',
    },
    'a rock in range of a corner': {
      why: (d) =>
        whyNot(
          levelWith({ asteroids: [at(700 + 0.6 * d, -100 - 0.8 * d), at(0, 20)], blackHole: spot(600, 0) }),
          square(600, 0, 100),
        ),
      truth: RANGE,
      safe: 'above',
      slack: [1e-7, 2e-7],
      says: 'of the barrier: it is in range of asteroid 1',
    },
    'a rock that recoil drags into range of an edge': {
      why: (d) =>
        whyNot(
          levelWith({ asteroids: [at(600 - 100 - d, 40, 10)], blackHole: spot(600, 0), recoil: true }),
          square(600, 0, 100),
          { maxTime: 20 },
        ),
      truth: RANGE + 400 / (2 * 10) / 2,
      safe: 'above',
      slack: [0.1, 0.101],
      says: 'edge 4 of the barrier: it is in range of asteroid 1',
    },
    'with frames an edge out of range by half a jump': {
      why: (d) =>
        whyNot(
          levelWith({ astronaut: { ...ORIGIN, vx: 0, vy: 700 }, asteroids: [at(600, 100 + d)], blackHole: spot(600, 0) }),
          square(600, 0, 100),
          { covers: FRAMES },
        ),
      // 850 px wide, and as high as the asteroid's range extends downwards.
      truth: Array.from({ length: 50 }).reduce<number>((d) => RANGE + jumpOf(850, 100 + d + RANGE, 700) / 2, RANGE),
      safe: 'above',
      slack: [1e-7, 3e-7],
      says: 'edge 3 of the barrier: it is in range of asteroid 1',
      reach: 2,
    },
    'a hot asteroid that recoil drags': {
      why: (r) =>
        whyNot(
          pen({ novae: [at(7000, 0), ...FOUR.slice(1)], asteroids: [at(0, 20), hot(0, -600, r)], recoil: true }),
          barrier([-100, -100, { kind: 'asteroid', index: 1 }], [100, -100, nova(1)], [100, 100, nova(2)], [-100, 100, nova(3)]),
          { maxTime: 60 },
        ),
      // It must reach the corners wherever it is dragged within a minute: r + 10 - 3600 / (4 r) = its distance from them.
      truth: (() => {
        const d = Math.hypot(100, 500) - 10;
        return (d + Math.sqrt(d * d + 3600)) / 2;
      })(),
      safe: 'above',
      // 1 % of 1.8 px.
      slack: [0.0176, 0.018],
      says: 'edge 1 of the barrier: it leaves the hazard it names',
    },
  });

  it('the start lies on no edge', () => {
    const level = levelWith({ blackHole: spot(600, 0) });
    const through = (x: number) =>
      whyNot(level, barrier([x, -50, range], [x, 50, range], [x - 200, 50, range], [x - 200, -50, range]));
    for (const x of [0, 5e-8, -5e-8]) expect(through(x)).toBe('the start lies on edge 1 of the barrier');
    expect(through(3e-7)).toBeNull();
    expect(through(-3e-7)).toBe('the barrier does not lie between the start and it');
    const below = (y: number) =>
      whyNot(level, barrier([-50, y, range], [50, y, range], [50, y - 200, range], [-50, y - 200, range]));
    for (const y of [0, 5e-8, -5e-8]) expect(below(y)).toBe('the start lies on edge 1 of the barrier');
    expect(below(3e-7)).toBeNull();
    expect(below(-3e-7)).toBe('the barrier does not lie between the start and it');
  });

  it('what blocks, and what does not', () => {
    const by = (blocker: Blocker | undefined, more: Partial<LevelFile> = {}, asked?: Asked) =>
      whyNot(
        pen({ novae: [at(9000, 0, 50), ...FOUR.slice(1)], ...more }),
        barrier([-100, -100, blocker as Blocker], [100, -100, nova(1)], [100, 100, nova(2)], [-100, 100, nova(3)]),
        asked,
      );
    const none = 'edge 1 of the barrier: it names something other than a hazard that stands still';
    const top = at(0, -600, 600);
    expect(by({ kind: 'asteroid', index: 1 }, { asteroids: [at(0, 20), hot(0, -600, 600)] })).toBeNull();
    expect(by({ kind: 'asteroid', index: 1 }, { asteroids: [at(0, 20), top] })).toBe(none);
    expect(by({ kind: 'asteroid', index: 2 }, { asteroids: [at(0, 20), hot(0, -600, 600)] })).toBe(none);
    expect(by({ kind: 'alien', index: 0 }, { aliens: [top] })).toBe(none);
    expect(by({ kind: 'nova', index: 4 })).toBe(none);
    expect(by({ kind: 'nova', index: -1 })).toBe(none);
    expect(by({ kind: 'nova', index: 0 })).toBe('edge 1 of the barrier: it leaves the hazard it names');
    expect(by(undefined)).toBe(none);
    expect(by({ kind: 'repulsor' as never, index: 0 }, { repulsors: [top] })).toBe(none);
    // Touching the black hole ends the run before a mineral beyond it.
    const mineral = { minerals: [spot(400, 0)], blackHole: top };
    expect(by({ kind: 'blackHole', index: 0 }, mineral, { about: MINERAL })).toBeNull();
    expect(by({ kind: 'blackHole', index: 0 }, mineral)).not.toBeNull();
    expect(by({ kind: 'alien', index: 0 }, { ...mineral, aliens: [top] }, { about: MINERAL })).toBe(none);
    expect(by(undefined, mineral, { about: MINERAL })).toBe(none);
  });

  it('a malformed barrier', () => {
    const level = levelWith({ blackHole: spot(600, 0) });
    const whole = square(600, 0, 100).barrier;
    const why = (list: unknown) => whyNot(level, { kind: 'enclosed', barrier: list as never });
    expect(why(whole)).toBeNull();
    expect(why(whole.slice(0, 3))).not.toBe('its barrier is not a closed line');
    for (const list of [undefined, null, 'line', [], whole.slice(0, 2), { length: 4 }])
      expect(why(list)).toBe('its barrier is not a closed line');
    // A repeated corner is an edge of length 0.
    expect(why([...whole, whole[3]])).toBeNull();
    const triangle = barrier([500, -100, range], [800, 0, range], [500, 100, range]).barrier;
    expect(why(triangle)).toBeNull();
    for (const corner of [
      null,
      undefined,
      {},
      { x: 1, by: range },
      { y: 1, by: range },
      { x: 1, y: Number.NaN, by: range },
      { x: '1', y: 0, by: range },
    ])
      expect(why([...whole, corner])).toBe('a corner of its barrier is not a point');
  });

  it('is a line between the start and the object, however it winds: the number of its crossings decides on which side they are', () => {
    // A star around a place: what is closer to it than the line in that direction is inside.
    const star = fc.record({
      reaches: fc.array(fc.integer({ min: 60, max: 200 }), { minLength: 3, maxLength: 9 }),
      x: fc.integer({ min: -300, max: 300 }),
      y: fc.integer({ min: -300, max: 300 }),
      hole: fc.tuple(fc.integer({ min: -400, max: 400 }), fc.integer({ min: -400, max: 400 })),
    });
    let between = 0;
    fc.assert(
      fc.property(star, ({ reaches, x, y, hole }) => {
        const n = reaches.length;
        const corner = (i: number) => {
          const turn = (2 * Math.PI * i) / n;
          return { x: x + reaches[i % n] * Math.cos(turn), y: y + reaches[i % n] * Math.sin(turn) };
        };
        const isInside = (px: number, py: number) => {
          const cross = (a: { x: number; y: number }, b: { x: number; y: number }) =>
            (b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x);
          return Array.from({ length: n }, (_, i) => i).some(
            (i) => cross({ x, y }, corner(i)) >= 0 && cross(corner(i), corner(i + 1)) >= 0 && cross(corner(i + 1), { x, y }) >= 0,
          );
        };
        const corners = Array.from({ length: n }, (_, i): Corner => [corner(i).x, corner(i).y, range]);
        const why = whyNot(levelWith({ blackHole: spot(...hole) }), barrier(...corners));
        const isBetween = isInside(0, 0) !== isInside(...hole);
        if (why === null) {
          expect(isBetween).toBe(true);
          between++;
        } else if (why.includes('does not lie between')) expect(isBetween).toBe(false);
      }),
      { numRuns: 400 },
    );
    expectDeep(between).toBeGreaterThan(20);
  });

  it('a corner at the height of the start is crossed once', () => {
    const level = levelWith({ blackHole: spot(-900, 0) });
    const diamond = barrier([150, 0, range], [0, 150, range], [-150, 0, range], [0, -150, range]);
    expect(whyNot(level, diamond)).toBeNull();
    const aside = barrier([350, 0, range], [200, 150, range], [50, 0, range], [200, -150, range]);
    expect(whyNot(level, aside)).toBe('the barrier does not lie between the start and it');
    const above = barrier([350, 0, range], [200, -150, range], [50, 0, range], [200, -50, range]);
    expect(whyNot(level, above)).toBe('the barrier does not lie between the start and it');
  });

  it('covers every accuracy that it claims', () => {
    expect(whyNot(pen(), walls(100), { covers: ALL })).toBeNull();
  });
});
