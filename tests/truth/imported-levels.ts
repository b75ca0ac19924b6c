import type { Level } from '../../schema/index.ts';
import { originalLevels } from './recordings.ts';

// biome-ignore lint/suspicious/noExplicitAny: until importOriginal is there
type Anything = any;

/** The original's levels by their number (the place in its array), as the toolkit imports them. */
export function importedLevels(): Map<number, Level> {
  const list = JSON.parse(originalLevels()) as Anything[];
  const circle = (o: Anything, radius?: number) => ({ id: null, x: o.x, y: o.y, radius: radius ?? Number(o.radius) });
  const found = new Map<number, Level>();
  for (const [number, o] of list.entries()) {
    if (!o.player) continue;
    found.set(number, {
      name: `level ${number}`,
      description: '',
      astronaut: { x: o.player.x, y: o.player.y, vx: o.player.vx ?? 0, vy: o.player.vy ?? 0 },
      blackHole: { x: o.target.x, y: o.target.y, radius: Number(o.target.radius) },
      range: o.maxDistance,
      recoil: true,
      asteroids: (o.asteroids ?? []).map((a: Anything) => ({ ...circle(a), hot: a.enemy === true })),
      novae: (o.novae ?? []).map((a: Anything) => circle(a)),
      repulsors: (o.antiForceFields ?? []).map((a: Anything) => circle(a)),
      aliens: (o.aliens ?? []).map((a: Anything) => circle(a, 25)),
      minerals: (o.goodies ?? []).map((a: Anything) => circle(a, 7)),
      runs: [],
    });
  }
  return found;
}
