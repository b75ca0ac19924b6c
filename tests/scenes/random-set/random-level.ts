import { LEVEL_VERSION, type LevelFile } from '../../../schema/index.ts';
import { seeded } from '../seeded.ts';

/** Number of levels in the set; their seeds are 0, 1, 2, ... */
export const RANDOM_SET_SIZE = 2000;

/** How a level of the set is laid out. */
export type Layout = 'scattered' | 'chained';

/** Even seeds are scattered, odd ones chained. */
export const layoutOf = (seed: number): Layout => (seed % 2 === 0 ? 'scattered' : 'chained');

interface Place {
  x: number;
  y: number;
}

/** Distance around the start that a chained level keeps free of hazards, px. */
const FREE_START = 60;

/**
 * One level of the frozen set, the same on every machine. Nothing is solved and no level is rejected: objects may overlap, and
 * many levels have no solution. In a scattered level she may start in a nova or out of range.
 *
 * - area: width and height uniform from 300 to 1600 px; every place is a whole number of px
 * - 1 to 15 asteroids, r 16 or 32; the probability of being hot is drawn for each level from 0 to 1/2, and is 0 in half of the
 *   levels
 * - 5 to 120 novae, r 16 or 32, uniform over the area
 * - aliens (1 to 6) in 40 % of the levels, repulsors (1 to 5, r 32 or 48) in 40 %, recoil in 50 %, 0 to 5 minerals
 * - range 250 px in 80 %, else 150 to 400; at rest in 80 %, else up to 60 px/s on each axis
 * - `scattered`: asteroids, start and black hole uniform over the area
 * - `chained`: each asteroid 100 to 300 px from an earlier one, the start at most 200 px from the first, the black hole at most
 *   300 px from the last; the area is their bounding box and 100 px more on each side. No nova, alien or hot asteroid has its
 *   centre within 60 px of the start: novae and aliens there are drawn again, and asteroids there are cold
 */
export function randomLevel(seed: number): LevelFile {
  const random = seeded(0x5eed + seed);
  const int = (least: number, most: number) => least + Math.floor(random() * (most - least + 1));
  const chance = (p: number) => random() < p;
  const list = <T>(count: number, make: () => T): T[] => Array.from({ length: count }, make);
  const near = (around: Place, least: number, most: number): Place => {
    for (;;) {
      const x = int(-most, most);
      const y = int(-most, most);
      const d = x * x + y * y;
      if (d >= least * least && d <= most * most) return { x: around.x + x, y: around.y + y };
    }
  };

  const area = { left: 0, top: 0, width: int(300, 1600), height: int(300, 1600) };
  const anywhere = (): Place => ({ x: area.left + int(0, area.width), y: area.top + int(0, area.height) });

  const asteroidCount = int(1, 15);
  const hotShare = chance(0.5) ? random() / 2 : 0;
  let start = anywhere();
  let blackHole = anywhere();
  const rocks: Place[] = [];
  if (layoutOf(seed) === 'scattered') rocks.push(...list(asteroidCount, anywhere));
  else {
    rocks.push(near(start, 0, 200));
    while (rocks.length < asteroidCount) rocks.push(near(rocks[int(Math.max(0, rocks.length - 3), rocks.length - 1)], 100, 300));
    blackHole = near(rocks[rocks.length - 1], 0, 300);
    const all = [start, blackHole, ...rocks];
    const left = Math.min(...all.map((p) => p.x)) - 100;
    const top = Math.min(...all.map((p) => p.y)) - 100;
    const move = (p: Place): Place => ({ x: p.x - left, y: p.y - top });
    area.width = Math.max(...all.map((p) => p.x)) + 100 - left;
    area.height = Math.max(...all.map((p) => p.y)) + 100 - top;
    start = move(start);
    blackHole = move(blackHole);
    for (const [i, rock] of rocks.entries()) rocks[i] = move(rock);
  }

  const isFree = ({ x, y }: Place): boolean => {
    const dx = x - start.x;
    const dy = y - start.y;
    return layoutOf(seed) === 'scattered' || dx * dx + dy * dy > FREE_START * FREE_START;
  };
  const somewhereFree = (): Place => {
    for (;;) {
      const place = anywhere();
      if (isFree(place)) return place;
    }
  };

  const asteroids = rocks.map((place) => {
    const hot = chance(hotShare) && isFree(place);
    return { ...place, radius: chance(0.5) ? 16 : 32, ...(hot && { hot }) };
  });
  const novae = list(int(5, 120), () => ({ ...somewhereFree(), radius: chance(0.5) ? 16 : 32 }));
  const aliens = list(chance(0.4) ? int(1, 6) : 0, somewhereFree);
  const repulsors = list(chance(0.4) ? int(1, 5) : 0, () => ({ ...anywhere(), radius: chance(0.5) ? 32 : 48 }));
  const minerals = list(int(0, 5), anywhere);
  const range = chance(0.8) ? 250 : int(150, 400);
  const moving = chance(0.2) && { vx: int(-60, 60), vy: int(-60, 60) };
  return {
    version: LEVEL_VERSION,
    name: `Random ${seed}`,
    astronaut: { ...start, ...moving },
    blackHole,
    range,
    recoil: chance(0.5),
    asteroids,
    novae,
    repulsors,
    aliens,
    minerals,
  };
}
