import { type Circle, type Hold, type Level, NO_OBJECTS } from '../../schema/index.ts';
import type { RandomScene } from './random-scene.ts';
import { seeded } from './seeded.ts';

/**
 * Makes a scene from a seed in which as much as possible coincides exactly or almost: starts on rims, on bisectors, in centres
 * and at the edges of sights and ranges; fields that coincide, touch from inside or outside, or cross where she starts;
 * mirrored asteroids; no velocity, or one along a rim; radii and ranges from the smallest to the largest. These are the scenes
 * in which something may happen endlessly.
 */
export function degenerateScene(seed: number): RandomScene {
  const random = seeded(seed ^ 0x7a57e);
  const int = (most: number) => Math.floor(random() * (most + 1));
  const chance = (p: number) => random() < p;
  const pick = <T>(...of: T[]): T => of[int(of.length - 1)];
  const between = (a: number, b: number) => a + (b - a) * random();
  // exact in binary, so that a place on a rim is exactly on it
  const directions: readonly (readonly [number, number])[] = [
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
    [0.6, 0.8],
    [-0.8, 0.6],
    [0.28, -0.96],
  ];
  const direction = () => pick(...directions);
  const nudge = () => (chance(0.6) ? 0 : pick(1, -1) * 10 ** -pick(15, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3));
  const circle = (x: number, y: number, radius: number): Circle => ({ id: null, x, y, radius: Math.max(1e-3, radius) });

  // she is at 0, 0; fields have her on their rims
  const repulsors: Circle[] = [];
  const rims = pick(0, 1, 1, 1, 2, 2, 3);
  for (let i = 0; i < rims; i++) {
    const before = repulsors.at(-1);
    if (before !== undefined && chance(0.5)) {
      // coincident, nested and touching at her place, or mirrored
      const r = pick(before.radius, before.radius, before.radius / 2, 2 * before.radius);
      const f = (pick(1, 1, 1, -1) * r) / before.radius;
      repulsors.push(circle(before.x * f + nudge(), before.y * f + nudge(), r + nudge()));
    } else {
      const [dx, dy] = direction();
      const r = pick(48, 48, 32, 50, 100, 5, 1, 1e-3, 1e3, 1e5, 1e6);
      repulsors.push(circle(r * dx + nudge(), r * dy + nudge(), r + nudge()));
    }
  }
  const range = pick(250, 250, 250, 1000, 60, 1e5, 1e6, 1);
  const asteroids: (Circle & { hot: boolean })[] = [];
  const far = () => pick(0, 1e-7, 2e-7, 1e-6, 1e-4, 1e-3, 0.1, 1, 5, 60, 100, 48, 150, 0.5 * range, range);
  const size = () => pick(16, 16, 32, 1, 1e-3, 1e-3, 0.1, 1e3);
  const count = 1 + int(2);
  for (let i = 0; i < count; i++) {
    const before = asteroids.at(-1);
    if (before !== undefined && chance(0.6)) {
      const [fx, fy] = pick([1, -1], [-1, 1], [-1, -1], [1, 1]);
      asteroids.push({ ...circle(before.x * fx + nudge(), before.y * fy + nudge(), pick(before.radius, size())), hot: false });
    } else {
      const [dx, dy] = chance(0.7) || repulsors.length === 0 ? direction() : [repulsors[0].x / repulsors[0].radius, 1e-3];
      const d = far();
      asteroids.push({ ...circle(d * dx + nudge(), d * dy + nudge(), size()), hot: false });
    }
  }
  // at rest, slow, or such that she orbits one of the objects
  const speed = chance(0.45) ? 0 : pick(1e-12, 1e-9, 1e-6, 1e-4, 1e-3, 1e-2, 0.1, 1, 5, 20, 40, 1000);
  const [vx, vy] = direction();
  const first = asteroids[0];
  const orbit = Math.sqrt(Math.sqrt(first.x * first.x + first.y * first.y) * pick(39, 39 + 1 / (2 * first.radius)));
  const along = chance(0.3) && orbit < 900 ? orbit : speed;
  const level: Level = {
    name: `degenerate scene ${seed}`,
    description: '',
    astronaut: { x: 0, y: 0, vx: along * vx, vy: along * vy },
    blackHole: { x: -3e6, y: 3e6, radius: 18 },
    range,
    recoil: chance(0.5),
    ...NO_OBJECTS,
    asteroids,
    novae: chance(0.1) ? [circle(between(20, 100), between(20, 100), 16)] : [],
    repulsors,
    aliens: chance(0.15) ? [circle(...edge(direction(), pick(150, 150, 60, 149.9999)), 25)] : [],
    runs: [],
  };
  const maxTime = 3;
  return { level, holds: rhythm(), maxTime };

  function edge([dx, dy]: readonly [number, number], d: number): [number, number] {
    return [d * dx + nudge(), d * dy + nudge()];
  }

  function rhythm(): Hold[] {
    if (chance(0.1)) return [];
    if (chance(0.6)) return [[0, 180]];
    const holds: Hold[] = [];
    const [on, off] = [pick(1, 1, 5, 20), pick(1, 1, 5, 20)];
    for (let tick = int(10); tick < 180; tick += on + off) holds.push([tick, Math.min(180, tick + on)]);
    return holds;
  }
}
