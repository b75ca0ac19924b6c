import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

/** The path of a shipped level. */
export const shipped = (slug: string): string => fileURLToPath(new URL(`../../levels/${slug}.level.json`, import.meta.url));

/** The file of a shipped level, without its runs. */
export function withoutRuns(slug: string): string {
  const file = JSON.parse(readFileSync(shipped(slug), 'utf8'));
  return JSON.stringify({ ...file, $schema: undefined, runs: undefined });
}

/**
 * The black hole in a ring of novae with one gap that is hardly wider than the collision box: no proof excludes it, and no
 * short search gets through.
 */
export function narrowGap(): string {
  const [x, y] = [420, 120];
  const count = 16;
  const novae = Array.from({ length: count - 1 }, (_, i) => {
    const angle = Math.PI + (2 * Math.PI * (i + 1)) / count;
    return { x: x + 110 * Math.cos(angle), y: y + 110 * Math.sin(angle), radius: 16 };
  });
  // the two beside the gap leave 22 px
  const beside = [-1, 1].map((side) => ({ x: x - 110, y: y + side * 27, radius: 16 }));
  return JSON.stringify({
    version: 1,
    name: 'Needle',
    astronaut: { x: 100, y: 300, vx: 40 },
    blackHole: { x, y },
    asteroids: [{ x: 180, y: 180, radius: 32 }],
    novae: [...novae, ...beside],
  });
}

/** The output of gq without the parts that depend on the speed of the machine. */
export const withoutTimes = (text: string): string =>
  text.replace(/"(ms|seconds)":[\d.e-]+/g, '"$1":0').replace(/, \d+\.\d s, seed/g, ', 0.0 s, seed');

export const inDirectory = (directory: string, name: string): string => readFileSync(join(directory, name), 'utf8');
