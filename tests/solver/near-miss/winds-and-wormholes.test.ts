import { describe } from 'vitest';
import type { LevelFile } from '../../../schema/index.ts';
import type { BarrierEdge, LineEnd } from '../../../solver/index.ts';
import { at, BOX, CONTINUOUS, doomedBy, FRAMES, levelWith, nearMisses, ORIGIN, RANGE, spot, TICK, whyNot } from './near-miss.ts';

// Near misses of rims: the disc of a wind or a mouth is varied until a path that is claimed to keep clear of it just does not.

const U = { x: 0.6, y: 0.8 };
const on = (along: number, aside = 0, radius = 16) => at(along * U.x - aside * U.y, along * U.y + aside * U.x, radius);
const wormhole = (from: { x: number; y: number }, to: { x: number; y: number }, radius: number) => ({
  x: from.x,
  y: from.y,
  toX: to.x,
  toY: to.y,
  radius,
});
const AFAR = spot(0, -9000);
/** The limit of a frame's flight on both axes, which the checker rounds up. */
const FRAME = 1.4143 * 1000 * TICK;

describe('a line keeps clear of winds and mouths', () => {
  const nova = (where: number, index: number): LineEnd => ({ at: where, by: { kind: 'nova', index } });
  const swing = (more: Partial<LevelFile>) =>
    whyNot(levelWith({ asteroids: [on(60)], novae: [on(-80), on(200)], blackHole: spot(4000, 0), ...more }), {
      kind: 'line-trap',
      target: 0,
      back: nova(-60, 0),
      front: nova(180, 1),
      drift: null,
    });
  const slack = [0.01 - 1e-6, 0.01 + 1e-5] as const;
  nearMisses({
    'a wind beside it': {
      why: (d) => swing({ winds: [{ ...on(100, d, 40), ax: 1, ay: 0 }] }),
      truth: 40,
      safe: 'above',
      slack,
      says: 'wind 1 may act on her on the stretch',
    },
    'a mouth beside it': {
      why: (d) => swing({ wormholes: [wormhole(on(100, d), AFAR, 25)] }),
      truth: 25,
      safe: 'above',
      slack,
      says: 'a wormhole may take her off the stretch',
    },
    'the other mouth beside it': {
      why: (d) => swing({ wormholes: [wormhole(AFAR, on(100, -d), 25)] }),
      truth: 25,
      safe: 'above',
      slack,
      says: 'a wormhole may take her off the stretch',
    },
  });
});

describe('out-of-range, through a wormhole', () => {
  const says = (asteroids: number[], mouths: number[], more: Partial<LevelFile>, frames = false) =>
    whyNot(
      levelWith({ asteroids: [at(100, 0), at(0, 3000)], blackHole: spot(9000, 0), ...more }),
      { kind: 'out-of-range', asteroids, mouths },
      { covers: frames ? FRAMES : CONTINUOUS },
    );
  const slack = [0, 1e-5] as const;
  nearMisses({
    'a mouth that is just in range': {
      why: (d) => says([0], [], { wormholes: [wormhole(spot(100 + d, 0), AFAR, 30)] }),
      truth: RANGE + 30,
      safe: 'above',
      slack,
      says: 'a mouth is not listed, and she may reach it from asteroid 1',
    },
    'the same by frames': {
      why: (d) => says([0], [], { wormholes: [wormhole(spot(100 + d, 0), AFAR, 30)] }, true),
      truth: RANGE + 30 + FRAME,
      safe: 'above',
      slack,
      says: 'a mouth is not listed, and she may reach it from asteroid 1',
    },
    'an asteroid just in range of where she comes out': {
      why: (d) => says([0], [0, 1], { wormholes: [wormhole(spot(150, 0), spot(0, 3000 - d), 30)] }),
      truth: RANGE + 30,
      safe: 'above',
      slack,
      says: 'asteroid 2 is not listed, and she may come out of a mouth in range of it',
    },
    'the thing just in touch of where she comes out': {
      why: (d) => says([0], [0, 1], { wormholes: [wormhole(spot(150, 0), spot(9000 - d, 0), 30)] }),
      truth: 30 + 18 + BOX.halfDiagonal,
      safe: 'above',
      slack: [0, 1e-4],
      says: 'she may touch it as she comes out of a mouth',
    },
    'a mouth beside where she comes out': {
      why: (d) =>
        says([0], [0, 1], {
          wormholes: [wormhole(spot(150, 0), spot(0, 6000), 30), wormhole(spot(0, 6000 + d), spot(9000, 100), 20)],
        }),
      truth: 50,
      safe: 'above',
      slack,
      says: 'a mouth is not listed, and she may reach it out of another',
    },
  });
});

describe('enclosed, with a wormhole inside', () => {
  /** The start in a ring of novae; one side of the barrier goes straight down at 82 px to the right, through one of them. */
  const ring = Array.from({ length: 24 }, (_, i) =>
    at(100 * Math.cos((i * Math.PI) / 12), 100 * Math.sin((i * Math.PI) / 12), 16),
  );
  const barrier: BarrierEdge[] = ring.map(({ x, y }, index) => ({ x, y, by: { kind: 'nova', index } }));
  const mid = (i: number) => {
    const [a, b] = [ring[i], ring[(i + 1) % ring.length]];
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
  };
  // Each nova holds its edge from halfway to the one before to halfway to the next.
  const edges: BarrierEdge[] = barrier.map(({ by }, i) => ({ ...mid((i + 23) % 24), by }));
  const inside = (wormholes: LevelFile['wormholes']) =>
    whyNot(levelWith({ asteroids: [at(20, 0, 5)], novae: ring, blackHole: spot(600, 0), wormholes }), {
      kind: 'enclosed',
      barrier: edges,
    });
  // The right edge goes straight down, at this distance from the start.
  const far = mid(0).x - ORIGIN.x;
  nearMisses({
    'a mouth that comes near the barrier': {
      why: (x) => inside([wormhole(spot(0, 40), spot(x, 0), 12)]),
      truth: far - 12,
      safe: 'below',
      slack: [0, 1e-5],
      says: 'the barrier',
    },
  });
});

describe('doomed keeps clear of mouths', () => {
  const grid = { axis: [-1, 0], cell: 8, bin: 16, frames: 6 } as const;
  const wall = (d: number) =>
    levelWith({
      astronaut: { ...spot(0, 0), vx: -60 },
      asteroids: [at(100, 0)],
      novae: [at(-60, 0, 32), at(-60, 60, 32), at(-60, -60, 32)],
      wormholes: [wormhole(spot(d, 0), AFAR, 10)],
    });
  nearMisses({
    // Within a step the strongest push bends her path by this much.
    'behind the start': {
      why: (d) => whyNot(wall(d), doomedBy(grid, 20)(wall(4000))),
      truth: 10,
      safe: 'above',
      slack: [0.2, 0.3],
      says: 'she may enter a wormhole in step',
      reach: 9,
    },
  });
});
