import { type Circle, type Hold, type Level, NO_OBJECTS } from '../../schema/index.ts';
import { seeded } from './seeded.ts';

export interface RandomScene {
  readonly level: Level;
  readonly holds: readonly Hold[];
  /** Simulated time, s. */
  readonly maxTime: number;
}

/**
 * Makes a scene and a script from a seed, the same on every machine: every kind of object, dense and sparse, on a coarse grid
 * (exact ties, objects on top of each other) or anywhere, radii from 0.1 to 400 px, starts at rest and up to the speed limit.
 */
export function randomScene(seed: number): RandomScene {
  const random = seeded(seed);
  const int = (most: number) => Math.floor(random() * (most + 1));
  const chance = (p: number) => random() < p;
  const between = (a: number, b: number) => a + (b - a) * random();
  const pick = <T>(...of: T[]): T => of[int(of.length - 1)];

  const grid = pick(0, 0, 0, 1, 5, 20, 50);
  const spread = pick(60, 150, 300, 300, 500, 900);
  const originX = chance(0.1) ? pick(1e3, 2 ** 20, -(2 ** 30), 1e9 - 5e3) : 0;
  const originY = chance(0.1) ? pick(1e3, 2 ** 20, -(2 ** 30)) : 0;
  const wild = chance(0.3);
  const place = (far: number): [number, number] => {
    const x = between(-far, far);
    const y = chance(0.1) ? 0 : between(-far, far);
    return grid > 0 ? [Math.round(x / grid) * grid, Math.round(y / grid) * grid] : [x, y];
  };
  const shared = [place(spread), place(spread)];
  const somewhere = (): [number, number] => (chance(0.08) ? shared[int(1)] : place(spread));
  const radius = (...usual: number[]) =>
    wild && chance(0.5) ? (chance(0.5) ? 0.1 + 400 * random() ** 4 : pick(0.1, 1, 50, 100, 400)) : pick(...usual);
  const circle = (r: number): Circle => {
    const [x, y] = somewhere();
    return { id: null, x: originX + x, y: originY + y, radius: r };
  };
  const list = <T>(most: number, make: () => T): T[] => Array.from({ length: chance(0.35) ? 0 : int(most) }, make);
  // a hazard at the start would leave nothing to examine: most are placed off her path
  const awayFromStart = (make: () => Circle): Circle => {
    let c = make();
    for (let n = 0; n < 8 && !(wild && n > 1); n++) {
      if (Math.abs(c.x - originX) > c.radius + 30 || Math.abs(c.y - originY) > c.radius + 30) break;
      c = make();
    }
    return c;
  };

  const asteroids = Array.from({ length: chance(0.03) ? 0 : 1 + int(pick(1, 2, 4, 9)) }, () => {
    const hot = chance(0.2);
    const make = () => circle(radius(16, 32));
    return { ...(hot ? awayFromStart(make) : make()), hot };
  });
  const speed = pick(0, 0, 0, 20, 100, 300, 1000);
  const velocity = () => (grid > 0 && speed > 0 && chance(0.6) ? pick(-speed, 0, speed) : between(-speed, speed));
  const range = wild && chance(0.4) ? pick(0.5, 20, 60, 100, 5000) : pick(150, 250, 250, 400, 1000);
  // a run that is lost at once shows little: mostly some asteroid keeps her in range
  if (asteroids.length > 0 && !chance(0.05)) {
    const [x, y] = place(0.7 * range);
    asteroids[0] = { ...asteroids[0], x: originX + x, y: originY + y };
  }
  const level: Level = {
    name: `random scene ${seed}`,
    description: '',
    astronaut: { x: originX, y: originY, vx: velocity(), vy: velocity() },
    blackHole: awayFromStart(() => circle(radius(18))),
    range,
    recoil: chance(0.4),
    ...NO_OBJECTS,
    asteroids,
    novae: list(pick(1, 4), () => awayFromStart(() => circle(radius(16, 32)))),
    repulsors: list(pick(1, 2, 6), () => circle(radius(32, 48, 100))),
    aliens: list(pick(1, 3, 8), () => awayFromStart(() => circle(radius(25)))),
    minerals: list(pick(3, 8), () => circle(radius(7))),
    runs: [],
  };
  const maxTime = pick(5, 10, 10, 20);
  return { level, holds: randomHolds(random, maxTime * 60), maxTime };
}

/** A script as people press: one long hold, taps of one tick, holds back to back, or a rhythm. */
export function randomHolds(random: () => number, lastTick: number): Hold[] {
  const longest = [1, 6, 30, 120, 10_000][Math.floor(random() * 5)];
  const pause = [0, 1, 20, 90][Math.floor(random() * 4)];
  const holds: Hold[] = [];
  let tick = random() < 0.4 ? 0 : Math.floor(random() * 60);
  while (tick < lastTick && holds.length < 200) {
    const press = tick;
    tick += 1 + Math.floor(random() * longest);
    holds.push([press, Math.min(tick, lastTick)]);
    tick += Math.floor(random() * (pause + 1));
  }
  return holds;
}
