import { resolveLevel } from '../../schema/index.ts';
import type { BenchScene } from './scene.ts';
import { seeded } from './seeded.ts';

const SPACING = 160;

/**
 * A field of `count` asteroids, one in each cell of a square grid, at a random place of its cell. She starts in the middle and
 * plays the same script of short holds at any size; it keeps her within 500 px of the middle. A larger `count` makes the field
 * larger, not denser.
 */
export function asteroidField(count: number): BenchScene {
  const random = seeded(20);
  const side = Math.ceil(Math.sqrt(count));
  const cells: { x: number; y: number; reach: number; radius: number }[] = [];
  for (let i = 0; i < side * side; i++) {
    const x = (i % side) - (side - 1) / 2;
    const y = Math.floor(i / side) - (side - 1) / 2;
    cells.push({ x, y, reach: Math.max(Math.abs(x), Math.abs(y)), radius: 0 });
  }
  // from the middle outwards, so that cells get the same random numbers at any even or odd size
  cells.sort((a, b) => a.reach - b.reach || a.y - b.y || a.x - b.x);
  const asteroids = cells.slice(0, count).map((cell) => ({
    x: Math.round(SPACING * (cell.x + 0.5 * (random() - 0.5))),
    y: Math.round(SPACING * (cell.y + 0.5 * (random() - 0.5))),
    radius: random() < 0.5 ? 16 : 32,
  }));
  return {
    name: `${count} asteroids`,
    what: `a field of ${count} cold asteroids, about one per ${SPACING} px squared`,
    level: resolveLevel({
      version: 1,
      name: `Field of ${count}`,
      astronaut: { x: 0, y: 0, vx: 20, vy: 10 },
      blackHole: { x: 1e6, y: 1e6 },
      asteroids,
    }),
    holds: Array.from({ length: 30 }, (_, i) => [60 * i, 60 * i + 40] as const),
    seconds: 30,
  };
}
