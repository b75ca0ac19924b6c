import { type Level, NO_OBJECTS } from '../../schema/index.ts';
import type { RandomScene } from './random-scene.ts';
import { seeded } from './seeded.ts';

type Disc = Pick<Level['novae'][number], 'id' | 'x' | 'y' | 'radius'>;

const DIRECTIONS = [
  ...([
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
  ] as const),
  ...([
    [0.6, 0.8],
    [-0.8, 0.6],
    [0.8, -0.6],
    [-0.6, -0.8],
  ] as const),
];

/** Half a second in which much is decided at time 0: her box touches something exactly, she is on a rim, or aliens touch. */
export function startScene(seed: number): RandomScene {
  const random = seeded(seed ^ 0x3517ab);
  const int = (most: number) => Math.floor(random() * (most + 1));
  const chance = (p: number) => random() < p;
  const pick = <T>(...of: T[]): T => of[int(of.length - 1)];
  const list = <T>(p: number, most: number, make: () => T): T[] =>
    chance(p) ? Array.from({ length: 1 + int(most - 1) }, make) : [];
  const [x, y] = chance(0.1) ? [2 ** 20, -(2 ** 10)] : [0, 0];
  const square = chance(0.25);
  const disc = (dx: number, dy: number, radius: number): Disc => ({ id: null, x: x + dx, y: y + dy, radius });

  /** Touches a side or a corner of her box as it stands or turned by a right angle, but for a gap. */
  const thing = (): Disc => {
    const r = pick(5, 10, 16, 20, 25, 30, 50);
    const gap = pick(0, 0, 0, 0, -1, -3, 1, 2);
    const [hw, hh] = square ? [10, 10] : pick([10, 16], [10, 16], [16, 10]);
    const [sx, sy] = [pick(1, -1), pick(1, -1)];
    if (chance(0.25) && r % 5 === 0) {
      const [dx, dy] = pick([0.6, 0.8], [0.8, 0.6]);
      return disc(sx * (hw + dx * r), sy * (hh + dy * r), r);
    }
    const along = pick(0, 0, 1, -2, 3, 5);
    return chance(0.6) ? disc(sx * (hw + r + gap), along, r) : disc(along, sy * (hh + r + gap), r);
  };
  /** She starts on its rim. */
  const around = (r: number): Disc => {
    const [dx, dy] = pick(...DIRECTIONS.slice(0, r % 5 === 0 ? 8 : 4));
    return disc(dx * r, dy * r, r);
  };
  const area = (): Disc => {
    const r = pick(20, 25, 50, 100);
    if (chance(0.5)) return around(r);
    return chance(0.5) ? disc(int(40) - 20, int(40) - 20, r) : disc(pick(1, -1) * (r + pick(0, 1, 5)), pick(0, 3), r);
  };
  const far = pick(50, 100, 200);
  const asteroid = () => ({ ...around(far), radius: pick(5, 16), hot: false });
  const asteroids = [asteroid(), ...list(0.3, 1, asteroid), ...list(0.3, 1, () => ({ ...thing(), hot: true }))];
  const aliens: Disc[] = [];
  for (let n = chance(0.6) ? 1 + int(3) : 0; n > 0; n--) {
    if (aliens.length === 0 || chance(0.5)) {
      aliens.push(thing());
      continue;
    }
    // beside another one
    const other = pick(...aliens);
    const radius = pick(5, 10, 25);
    const [dx, dy] = pick(...DIRECTIONS);
    const reach = other.radius + radius - pick(0, 0, 5);
    aliens.push({ id: null, x: other.x + dx * reach, y: other.y + dy * reach, radius });
  }
  const speed = chance(0.5) ? 0 : pick(5, 10, 20, 40, 100);
  const [dx, dy] = pick(...DIRECTIONS);
  const strength = () => pick(0, 5, -20, 20, 40, -100, 39);
  const rules = {
    ...(square ? { boxHeight: 20 } : {}),
    ...(chance(0.2) ? { alienPull: pick(0, 40, 200) } : {}),
    ...(chance(0.2) ? { alienSight: pick(0, 30, 50, 60) } : {}),
    ...(chance(0.1) ? { pull: pick(0, 10) } : {}),
    ...(chance(0.1) ? { speedLimit: pick(10, 20, 40) } : {}),
  };
  const level: Level = {
    name: `start scene ${seed}`,
    description: '',
    ...NO_OBJECTS,
    astronaut: { x, y, vx: Math.round(dx * speed), vy: Math.round(dy * speed) },
    blackHole: chance(0.35) ? thing() : { x: x - 1000, y: y - 1000, radius: 18 },
    range: pick(1000, 1000, far, 250),
    recoil: chance(0.3),
    asteroids,
    novae: list(0.35, 2, thing),
    repulsors: list(0.3, 2, area),
    aliens,
    minerals: list(0.3, 2, thing),
    winds: list(0.4, 2, () => ({ ...area(), ax: strength(), ay: strength() })),
    wormholes: list(0.3, 2, () => {
      const r = pick(10, 25, 50);
      const mouth = chance(0.6) ? around(r) : disc(pick(1, -1) * (r + 2), 0, r);
      const [wayX, wayY] = pick([100, 0], [0, 100], [-40, 30], [1, 0]);
      return { ...mouth, toX: mouth.x + wayX, toY: mouth.y + wayY };
    }),
    ...(Object.keys(rules).length > 0 ? { rules } : {}),
    runs: [],
  };
  return { level, holds: pick([], [[0, 30]], [[0, 30]], [[0, 1]], [[1, 30]], [[5, 30]]), maxTime: pick(0.25, 0.4) };
}
