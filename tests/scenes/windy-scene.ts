import { type Level, NO_OBJECTS } from '../../schema/index.ts';
import { degenerateScene } from './degenerate-scene.ts';
import { type RandomScene, randomScene } from './random-scene.ts';
import { seeded } from './seeded.ts';

/** A random scene with winds and wormholes: on top of other objects, of each other and of her, along her line and across it. */
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

/**
 * A degenerate scene with equally degenerate winds and wormholes: rims on which she starts or that coincide with those of
 * fields, mouths in the same place, in each other and in a ring, winds that balance the pull or push exactly.
 */
export function windyDegenerateScene(seed: number): RandomScene {
  const scene = degenerateScene(seed);
  const { level } = scene;
  const random = seeded(seed ^ 0x3a1d5);
  const chance = (p: number) => random() < p;
  const pick = <T>(...of: T[]): T => of[Math.floor(random() * of.length)];
  const nudge = () => (chance(0.6) ? 0 : pick(1, -1) * 10 ** -pick(15, 13, 11, 9, 8, 7, 6, 4, 3));
  const discs: { x: number; y: number; radius: number }[] = [...level.repulsors];
  /** A disc around her, with her on its rim, or at the place of another disc. */
  const disc = () => {
    const before = discs.length > 0 && chance(0.5) ? pick(...discs) : null;
    const radius =
      before === null ? pick(48, 32, 100, 5, 1, 0.1, 1e3, 1e5) : pick(before.radius, before.radius, before.radius / 2);
    const [dx, dy] = pick([0, 0], [1, 0], [-1, 0], [0, 1], [0, -1], [0.6, 0.8], [-0.8, 0.6]);
    const made =
      before === null
        ? { x: radius * dx + nudge(), y: radius * dy + nudge(), radius }
        : { x: before.x + pick(0, 0, 1, 2) * before.radius * dx + nudge(), y: before.y + nudge(), radius };
    discs.push(made);
    return made;
  };
  const strength = () => pick(0, 0, 39, -39, 20, -20, 19.999, 100, -100, 1e-9, 5 + nudge());
  const winds = Array.from({ length: pick(0, 1, 1, 2, 3) }, () => ({ id: null, ...disc(), ax: strength(), ay: strength() }));
  const wormholes = Array.from({ length: pick(0, 1, 1, 2, 3) }, () => {
    const { x, y, radius } = disc();
    const to = disc();
    return { id: null, x, y, toX: to.x, toY: to.y, radius };
  });
  return { ...scene, level: { ...level, name: `windy degenerate scene ${seed}`, winds, wormholes } };
}

/**
 * A windy scene that small steps can follow: a point among asteroids that stand still, repulsors, winds and wormholes, slower
 * than the speed limit and never out of range.
 */
export function steppableScene(seed: number): RandomScene {
  const { level, holds } = windyScene(seed);
  const { x, y } = level.astronaut;
  const scale = Math.min(1, 100 / Math.max(1, Math.abs(level.astronaut.vx), Math.abs(level.astronaut.vy)));
  const [vx, vy] = [scale * level.astronaut.vx, scale * level.astronaut.vy];
  // if there is none, one is placed on her path
  const inHerWay = { id: null, x: x + vx / 2, y: y + vy / 2 };
  const maxTime = 2;
  return {
    level: {
      ...level,
      ...NO_OBJECTS,
      name: `steppable scene ${seed}`,
      astronaut: { x, y, vx, vy },
      blackHole: { x: x + 1e7, y, radius: 18 },
      range: 5000,
      recoil: false,
      asteroids: level.asteroids.length === 0 ? [{ id: null, x: x + 100, y, radius: 16, hot: false }] : level.asteroids.map(cold),
      repulsors: level.repulsors,
      winds: level.winds.length === 0 ? [{ ...inHerWay, radius: 40, ax: 20, ay: -35 }] : level.winds,
      wormholes: level.wormholes.length === 0 ? [{ ...inHerWay, toX: x + 60, toY: y - 80, radius: 24 }] : level.wormholes,
    },
    holds: holds.filter(([press]) => press < 60 * maxTime),
    maxTime,
  };
}

const cold = (asteroid: Level['asteroids'][number]): Level['asteroids'][number] => ({ ...asteroid, hot: false });
