import type { LevelFile } from '../../schema/index.ts';
import { seeded } from './seeded.ts';

type Place = { readonly x: number; readonly y: number };

const level = (name: string, rest: Partial<LevelFile>): LevelFile => ({
  version: 1,
  name,
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 0, y: 5000 },
  asteroids: [{ x: 120, y: 0, radius: 16 }],
  ...rest,
});

const many = <T>(count: number, make: (i: number) => T): T[] => Array.from({ length: count }, (_, i) => make(i));

/** Places of a square grid around the start, without the nearest ring. */
function grid(count: number, step: number): Place[] {
  const side = Math.ceil(Math.sqrt(count)) + 2;
  const places: Place[] = [];
  for (let i = 0; i < side * side && places.length < count; i++) {
    const x = ((i % side) - side / 2) * step;
    const y = (Math.floor(i / side) - side / 2) * step;
    if (Math.abs(x) > 100 || Math.abs(y) > 100) places.push({ x, y });
  }
  return places;
}

/** Holds of one tick each. */
export const taps = (count: number, from = 0, every = 2): [number, number][] =>
  many(count, (i): [number, number] => [from + every * i, from + every * i + 1]);

/**
 * Valid levels that are expensive to check: each has an extreme number of one thing, at a size that fits into a file of 8 MiB.
 * Deterministic. `size` scales them; 1 is a size at which a check once took unreasonably long.
 */
export const HEAVY_LEVELS: Readonly<Record<string, (size?: number) => LevelFile>> = {
  'aliens-on-the-path': (size = 1) =>
    level('Aliens on the path', {
      astronaut: { x: 0, y: 0, vx: 1000, vy: 0 },
      range: 1e6,
      aliens: many(500 * size, (i) => ({ x: 400 + 60 * i, y: i % 2 === 0 ? 70 : -70, radius: 10 })),
      runs: [{ name: 'drift', holds: [[30, 40]] }],
    }),
  'two-thousand-aliens-on-the-path': (size = 1) =>
    level('Two thousand aliens on the path', {
      astronaut: { x: 0, y: 0, vx: 1000, vy: 0 },
      range: 1e6,
      aliens: many(2000 * size, (i) => ({ x: 400 + 25 * i, y: i % 2 === 0 ? 70 : -70, radius: 10 })),
      runs: [{ name: 'drift', holds: [[30, 40]] }],
    }),
  'ring-of-aliens': (size = 1) =>
    level('Ring of aliens', {
      aliens: many(1000 * size, (i) => {
        const turn = (2 * Math.PI * i) / (1000 * size);
        return { x: Math.round(9000 * size * Math.cos(turn)), y: Math.round(9000 * size * Math.sin(turn)), radius: 20 };
      }),
      runs: many(20, (i) => ({ name: `run ${i}`, holds: [[i, i + 600]] })),
    }),
  'one-awake-alien': (size = 1) =>
    level('One awake among many', {
      aliens: [{ x: -140, y: 100, radius: 5 }, ...grid(20_000 * size - 1, 400).map((p) => ({ ...p, radius: 5 }))],
      runs: [{ name: 'drift', holds: [[600, 700]] }],
    }),
  repulsors: (size = 1) =>
    level('Repulsors', {
      astronaut: { x: 0, y: 0, vx: 100, vy: 30 },
      range: 1e5,
      repulsors: grid(20_000 * size, 100).map((p) => ({ ...p, radius: 45 })),
      runs: [{ name: 'hold', holds: [[10, 200]] }],
    }),
  'heap-of-repulsors': (size = 1) =>
    level('Heap of repulsors', {
      range: 1e5,
      repulsors: many(20_000 * size, (i) => ({ x: (i % 100) / 10, y: Math.floor(i / 100) / 10, radius: 200 + (i % 7) })),
      runs: [{ name: 'hold', holds: [[10, 900]] }],
    }),
  'many-holds': (size = 1) =>
    level('Many holds', {
      runs: many(400 * size, (i) => ({ name: `run ${i}`, holds: taps(1500, i % 3) })),
    }),
  recoil: (size = 1) =>
    level('Recoil', {
      recoil: true,
      astronaut: { x: 0, y: 0, vx: 60, vy: 20 },
      asteroids: [{ x: 120, y: 0, radius: 16 }, ...grid(20_000 * size - 1, 120).map((p) => ({ ...p, radius: 16 }))],
      runs: [{ name: 'taps', holds: taps(300, 0, 8) }],
    }),
  'hot-recoil': (size = 1) =>
    level('Hot recoil', {
      recoil: true,
      asteroids: [{ x: 120, y: 0, radius: 16 }, ...grid(20_000 * size - 1, 150).map((p) => ({ ...p, radius: 16, hot: true }))],
      runs: [{ name: 'taps', holds: taps(300, 0, 8) }],
    }),
  'tiny-orbit': () =>
    level('Tiny orbit', {
      recoil: true,
      astronaut: { x: 0, y: 0, vx: 0, vy: 1e-3 },
      asteroids: [{ x: 3e-7, y: 0, radius: 0.001 }],
      runs: [{ name: 'hold', holds: [[0, 3600]] }],
    }),
  'coincident-repulsors': () =>
    level('Coincident repulsors', {
      astronaut: { x: 0, y: -48 },
      asteroids: [{ x: 0, y: 100, radius: 16 }],
      repulsors: [
        { x: 0, y: 0, radius: 48 },
        { x: 0, y: 0, radius: 48 },
      ],
      runs: [{ name: 'hold', holds: [[0, 3600]] }],
    }),
  'wormholes-in-one-place': (size = 1) =>
    level('Wormholes in one place', {
      wormholes: many(17_000 * size, () => ({ x: 60, y: 60, toX: 90, toY: 60, radius: 10 })),
    }),
  'many-runs-among-asteroids': (size = 1) =>
    level('Many runs among asteroids', {
      astronaut: { x: 0, y: 0, vx: -900, vy: 0 },
      blackHole: { x: -400, y: 0, radius: 40 },
      range: 600,
      asteroids: many(14_000 * size, (i) => ({ x: 3 * i, y: 200, radius: 0.1 })),
      runs: many(400 * size, (i) => ({ name: `run ${i}`, holds: taps(20, i % 3) })),
    }),
  'heap-of-aliens': (size = 1) =>
    level('Heap of aliens', {
      aliens: many(20_000 * size, () => ({ x: 900, y: 0 })),
      runs: [{ name: 'hold', holds: [[10, 200]] }],
    }),
  'awake-aliens': (size = 1) =>
    level('Awake aliens', {
      aliens: many(20_000 * size, (i) => {
        const turn = i * 2.399963229728653;
        const far = 40 + 100 * Math.sqrt(i / (20_000 * size));
        return { x: far * Math.cos(turn), y: far * Math.sin(turn), radius: 0.001 };
      }),
      runs: [{ name: 'hold', holds: [[10, 200]] }],
    }),
  everything: (size = 1) => {
    const random = seeded(7);
    const places = (count: number) =>
      many(count, () => ({ x: Math.round(40_000 * (random() - 0.5)), y: Math.round(40_000 * (random() - 0.5)) }));
    return level('Everything', {
      recoil: true,
      range: 1e5,
      astronaut: { x: 0, y: 0, vx: 200, vy: 100 },
      asteroids: places(20_000 * size).map((p, i) => ({ ...p, radius: 16, hot: i % 2 === 0 })),
      novae: places(20_000 * size).map((p) => ({ ...p, radius: 16 })),
      repulsors: places(20_000 * size).map((p) => ({ ...p, radius: 48 })),
      aliens: places(20_000 * size),
      minerals: places(20_000 * size),
      runs: [{ name: 'taps', holds: taps(100, 0, 30) }],
    });
  },
  novae: (size = 1) =>
    level('Novae', {
      range: 1e5,
      astronaut: { x: 0, y: 0, vx: 20, vy: 0 },
      novae: grid(20_000 * size, 140).map((p) => ({ ...p, radius: 16 })),
      runs: [{ name: 'hold', holds: [[10, 900]] }],
    }),
  'novae-no-run': (size = 1) =>
    level('Novae without a run', {
      range: 1e5,
      astronaut: { x: 0, y: 0, vx: 20, vy: 0 },
      novae: grid(20_000 * size, 140).map((p) => ({ ...p, radius: 16 })),
      minerals: many(20, (i) => ({ x: 140 * i + 70, y: 70 })),
    }),
  minerals: (size = 1) =>
    level('Minerals', {
      range: 1e5,
      minerals: grid(20_000 * size, 30).map((p) => ({ ...p })),
      runs: [{ name: 'hold', holds: [[10, 900]] }],
    }),
  'heap-of-novae': (size = 1) =>
    level('Heap of novae', {
      novae: many(20_000 * size, (i) => ({ x: 300 + (i % 100) / 10, y: Math.floor(i / 100) / 10, radius: 100 + (i % 7) })),
      runs: [{ name: 'hold', holds: [[10, 900]] }],
    }),
};
