import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { type Circle, type Hold, type Level, type LevelFile, NO_OBJECTS, resolveLevel } from '../../schema/index.ts';
import { hardCases } from '../hard-cases/cases.ts';

const levelsFolder = join(dirname(dirname(dirname(fileURLToPath(import.meta.url)))), 'levels');

/** A run whose hash is committed. */
export interface HashedRun {
  readonly name: string;
  readonly level: Level;
  readonly holds: readonly Hold[];
}

/** Every run of every shipped level. */
function shippedRuns(): HashedRun[] {
  return readdirSync(levelsFolder)
    .filter((file) => file.endsWith('.level.json'))
    .sort()
    .flatMap((file) => {
      const level = resolveLevel(JSON.parse(readFileSync(join(levelsFolder, file), 'utf8')) as LevelFile);
      return level.runs.map(({ name, holds }) => ({ name: `${file}: ${name}`, level, holds }));
    });
}

/** mulberry32: small, and whole numbers only, so that the scenes are the same whatever runs this. */
function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** A crowded scene of every kind of object in which a run goes on for a while. */
function randomRun(seed: number): HashedRun {
  const next = random(seed);
  const between = (low: number, high: number) => low + (high - low) * next();
  const some = (most: number) => Math.floor(next() * (most + 1));
  const circles = (count: number, radii: readonly number[], clear: number): Circle[] =>
    Array.from({ length: count }, () => {
      // a square ring around her start
      const [a, b] = [between(clear, 450) * (next() < 0.5 ? -1 : 1), between(-450, 450)];
      const [x, y] = next() < 0.5 ? [a, b] : [b, a];
      return { id: null, x, y, radius: radii[Math.floor(next() * radii.length)] };
    });
  const asteroids = circles(2 + some(6), [16, 32], 60).map((o) => ({ ...o, hot: next() < 0.2 }));
  const holds: Hold[] = [];
  for (let tick = Math.floor(between(0, 60)); tick < 1800; ) {
    const release = tick + 1 + Math.floor(between(5, 150));
    holds.push([tick, release]);
    tick = release + 1 + Math.floor(between(5, 90));
  }
  const level: Level = {
    name: `scene ${seed}`,
    description: '',
    astronaut: { x: 0, y: 0, vx: between(-30, 30), vy: between(-30, 30) },
    blackHole: { x: between(400, 600), y: between(-600, 600), radius: 18 },
    range: between(300, 900),
    recoil: next() < 0.5,
    ...NO_OBJECTS,
    asteroids,
    novae: circles(some(2), [16, 32], 120),
    repulsors: circles(some(3), [32, 48], 80),
    aliens: circles(some(3), [25], 110),
    minerals: circles(some(4), [7], 30),
    runs: [],
  };
  return { name: `scene ${seed}`, level, holds };
}

/** The hard cases, for the seconds a run has when nothing else is said. */
const hardRuns = (): HashedRun[] => hardCases().map(({ name, level, holds }) => ({ name: `hard: ${name}`, level, holds }));

/** What is hashed: all shipped runs, all hard cases, and 50 crowded scenes from fixed seeds. */
export const hashedRuns = (): HashedRun[] => [
  ...shippedRuns(),
  ...hardRuns(),
  ...Array.from({ length: 50 }, (_, i) => randomRun(i + 1)),
];
