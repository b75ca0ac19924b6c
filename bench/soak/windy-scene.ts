import type { Level } from '../../schema/index.ts';
import { seeded } from '../scenes/seeded.ts';
import { type RandomScene, randomScene } from './random-scene.ts';

/** A random scene with winds and wormholes in it: on top of other things, of each other and of her, along her line and across it. */
export function windyScene(seed: number): RandomScene {
  const scene = randomScene(seed);
  const { level } = scene;
  const random = seeded(seed + 1_000_003);
  const pick = <T>(...of: T[]): T => of[Math.floor(random() * of.length)];
  const there = [level.astronaut, ...level.asteroids, ...level.repulsors];
  const place = () => {
    const { x, y } = pick(...there);
    return random() < 0.2 ? { x, y } : { x: x + 300 * (random() - 0.5), y: y + 300 * (random() - 0.5) };
  };
  const strength = () => pick(0, 0, 5, -20, 20, 60 * (random() - 0.5), 100);
  const winds: Level['winds'] = Array.from({ length: Math.floor(random() * 4) }, () => ({
    id: null,
    ...place(),
    radius: pick(30, 60, 120, 400),
    ax: strength(),
    ay: strength(),
  }));
  const wormholes: Level['wormholes'] = Array.from({ length: Math.floor(random() * 3) }, () => {
    const { x: toX, y: toY } = place();
    return { id: null, ...place(), toX, toY, radius: pick(8, 24, 60) };
  });
  return { ...scene, level: { ...level, name: `windy scene ${seed}`, winds, wormholes } };
}
