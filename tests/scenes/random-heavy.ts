import type { LevelFile } from '../../schema/index.ts';
import { crowded } from './crowded.ts';
import { degenerateScene } from './degenerate-scene.ts';
import { HEAVY_LEVELS, taps } from './heavy-levels.ts';
import { seeded } from './seeded.ts';

/** Bytes that a level file may have, less a margin. */
const MOST_BYTES = 8 * 1024 * 1024 - 4096;

const MOST = 20_000;

/**
 * Makes a valid level from a seed that is as expensive to check as possible: many objects of one kind or all, in heaps, on
 * grids, on her path, over her or anywhere, with radii, ranges and speeds at both ends of the limits, and as many runs and holds as fit
 * into 8 MiB.
 */
export function randomHeavy(seed: number): LevelFile {
  const random = seeded(seed);
  const pick = <T>(...of: T[]): T => of[Math.floor(random() * of.length)];
  const chance = (p: number) => random() < p;
  if (chance(0.35)) return crowded(random, `crowded ${seed}`);
  if (chance(0.2)) return clusters(seed);
  if (chance(0.1)) {
    const names = Object.keys(HEAVY_LEVELS);
    return HEAVY_LEVELS[names[Math.floor(random() * names.length)]](pick(0.2, 0.5, 1));
  }
  const count = () => (chance(0.55) ? 0 : Math.floor(pick(100, 1000, 5000, MOST) * (0.5 + 0.5 * random())));
  const speed = pick(0, 0, 1e-3, 40, 1000);
  const turn = 2 * Math.PI * random();
  const vx = speed * Math.cos(turn);
  const vy = speed * Math.sin(turn);
  const style = () => {
    const kind = pick('heap', 'point', 'grid', 'way', 'ring', 'anywhere', 'sight');
    const size = pick(1, 30, 300, 3000, 1e5);
    const angle = pick(0, 0.3, 2.4);
    return (i: number, n: number): { x: number; y: number } => {
      switch (kind) {
        case 'point':
          return { x: size, y: 0 };
        case 'heap':
          return { x: size + 20 * random(), y: 20 * random() };
        case 'grid': {
          const side = Math.ceil(Math.sqrt(n));
          const step = Math.max(1e-3, size / 10);
          return { x: ((i % side) - side / 2 + 0.5) * step, y: (Math.floor(i / side) - side / 2 + 0.5) * step };
        }
        case 'way':
          return { x: vx * 0.02 * i * random() + 60 * (random() - 0.5), y: vy * 0.02 * i + 60 * (random() - 0.5) };
        case 'ring':
          return { x: size * Math.cos((2 * Math.PI * i) / n + angle), y: size * Math.sin((2 * Math.PI * i) / n + angle) };
        case 'sight':
          return { x: 40 + 100 * Math.cos(2.4 * i) * Math.sqrt(i / n), y: 100 * Math.sin(2.4 * i) * Math.sqrt(i / n) };
        default:
          return { x: size * (random() - 0.5), y: size * (random() - 0.5) };
      }
    };
  };
  const radius = () => {
    const least = pick(1e-3, 0.1, 7, 16, 32, 300, 1e5);
    return () => least * (1 + random());
  };
  const list = <T>(n: number, more: (i: number) => T) => {
    const place = style();
    const r = radius();
    return Array.from({ length: n }, (_, i) => ({ ...place(i, n), radius: r(), ...more(i) }));
  };
  const nothing = () => ({});
  const hot = pick(0, 0, 0.5, 1);
  const near = pick(3e-7, 1, 40, 120, 200);
  const level: LevelFile = {
    version: 1,
    name: `heavy ${seed}`,
    astronaut: { x: 0, y: 0, vx, vy },
    blackHole: { x: pick(300, 5000, 1e6), y: pick(0, 17, 4000), radius: pick(1e-3, 18, 400) },
    range: pick(150, 250, 250, 5000, 1e6),
    recoil: chance(0.4),
    asteroids: [
      { x: near, y: 0, radius: pick(1e-3, 16, 32, 300) },
      ...list(Math.min(MOST - 1, count()), () => ({ hot: random() < hot })),
    ],
    novae: list(count(), nothing),
    repulsors: list(count(), nothing),
    aliens: list(count(), nothing),
    minerals: list(count(), nothing),
    runs: [],
  };
  // she should survive for a while
  const clear = ({ x, y, radius: r = 25 }: { x: number; y: number; radius?: number }) => Math.hypot(x, y) > r + 20;
  level.novae = level.novae?.filter(clear);
  level.aliens = level.aliens?.filter(clear);
  level.asteroids = level.asteroids?.filter((a) => a.hot !== true || clear(a));
  const left = MOST_BYTES - JSON.stringify(level).length;
  const holds = pick(1, 20, 300, 1800);
  const every = pick(2, 2, 3, 30);
  const runs = Math.min(pick(0, 1, 1, 20, 400, 1000), Math.floor(left / (40 + 13 * holds)));
  level.runs = Array.from({ length: Math.max(0, runs) }, (_, i) => ({ name: `run ${i}`, holds: taps(holds, i % 7, every) }));
  return level;
}

/**
 * A few objects that almost touch, where each turn is interrupted by the next object. As many runs as fit, which differ in
 * their last hold.
 */
function clusters(seed: number): LevelFile {
  const { level, holds } = degenerateScene(seed);
  const { name, astronaut, blackHole, range, recoil } = level;
  const bare = <T extends { id: string | null }>(list: readonly T[]) => list.map(({ id: _, ...object }) => object);
  return {
    version: 1,
    name,
    astronaut,
    blackHole: { x: blackHole.x, y: blackHole.y, radius: Math.max(1, blackHole.radius) },
    range: Math.max(1, range),
    recoil,
    asteroids: bare(level.asteroids),
    novae: bare(level.novae),
    repulsors: bare(level.repulsors).map((field) => ({ ...field, radius: Math.min(1e6, field.radius) })),
    aliens: bare(level.aliens),
    minerals: bare(level.minerals),
    runs: [0, 1, 2, 3].map((n) => ({
      name: `run ${n}`,
      holds: [...holds, [2000 + 10 * n, 2400]] as [number, number][],
    })),
  };
}
