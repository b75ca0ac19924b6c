import { LEVEL_VERSION, type LevelFile } from '../../../schema/index.ts';
import { seeded } from '../seeded.ts';

/** Number of levels in the set; their seeds are 0, 1, 2, ... */
export const STYLED_SET_SIZE = 300;

/** How levels of the set are composed. */
export const STYLES = ['rings', 'corridors', 'slings', 'recoil', 'lattices', 'lures'] as const;

/** The style of a level. */
export type Style = (typeof STYLES)[number];

/** Styles take turns. */
export const styleOf = (seed: number): Style => STYLES[seed % STYLES.length];

interface Place {
  readonly x: number;
  readonly y: number;
}

/** Random choices of one level. */
interface Dice {
  readonly unit: () => number;
  readonly int: (least: number, most: number) => number;
  readonly chance: (p: number) => boolean;
}

type Composed = Omit<LevelFile, 'version' | 'name'>;

const around = ({ x, y }: Place, turn: number, distance: number): Place => ({
  x: Math.round(x + distance * Math.cos(turn)),
  y: Math.round(y + distance * Math.sin(turn)),
});

/** Circles along a segment, `step` px apart, with a gap of `gap` px whose middle lies at the share `at` of the segment. */
function fence(
  a: Place,
  b: Place,
  step: number,
  radius: number,
  at: number,
  gap: number,
): { x: number; y: number; radius: number }[] {
  const length = Math.hypot(b.x - a.x, b.y - a.y);
  const circles = [];
  for (let s = 0; s <= length; s += step) {
    if (Math.abs(s - at * length) < gap / 2 + radius) continue;
    circles.push({ x: Math.round(a.x + ((b.x - a.x) * s) / length), y: Math.round(a.y + ((b.y - a.y) * s) / length), radius });
  }
  return circles;
}

const START: Place = { x: 400, y: 400 };

const COMPOSE: Readonly<Record<Style, (dice: Dice) => Composed>> = {
  /** One to three asteroids, and a ring of novae with a gap around the black hole or the start. */
  rings({ unit, int, chance }) {
    const asteroids = [{ ...around(START, 2 * Math.PI * unit(), int(60, 160)), radius: 32 }];
    while (asteroids.length < int(1, 3))
      asteroids.push({ ...around(asteroids[0], 2 * Math.PI * unit(), int(150, 320)), radius: 16 });
    const blackHole = around(asteroids[asteroids.length - 1], 2 * Math.PI * unit(), int(60, 220));
    const centre = chance(0.7) ? blackHole : START;
    const r = int(70, 150);
    const gap = unit() * 1.1;
    const from = 2 * Math.PI * unit();
    const count = Math.ceil((2 * Math.PI * r) / int(34, 46));
    const novae = Array.from({ length: count }, (_, i) => ({ turn: from + (2 * Math.PI * i) / count, share: i / count }))
      .filter(({ share }) => share * 2 * Math.PI >= gap)
      .map(({ turn }) => ({ ...around(centre, turn, r), radius: 16 }));
    return { astronaut: { ...START }, blackHole, asteroids, novae };
  },
  /** Two walls with a row of asteroids between them, and sometimes a bar across. */
  corridors({ unit, int, chance }) {
    const half = int(60, 140);
    const length = int(500, 1100);
    const asteroids = [];
    for (let x = int(60, 160); x < length; x += int(140, 240)) {
      asteroids.push({ x: START.x + x, y: START.y + int(-half + 30, half - 30), radius: chance(0.5) ? 16 : 32 });
    }
    const novae = [-half, half].flatMap((y) =>
      fence(
        { x: START.x - 100, y: START.y + y },
        { x: START.x + length + 80, y: START.y + y },
        48,
        16,
        unit(),
        chance(0.3) ? 60 : 0,
      ),
    );
    if (chance(0.6)) {
      const x = START.x + int(length / 3, length - 60);
      novae.push(...fence({ x, y: START.y - half }, { x, y: START.y + half }, 30, 16, unit(), int(0, 70)));
    }
    const blackHole = { x: START.x + length, y: START.y + int(-half + 40, half - 40) };
    return { astronaut: { ...START, vx: chance(0.5) ? int(10, 70) : 0 }, blackHole, asteroids, novae };
  },
  /** A fast start past one or two asteroids: she is lost or through within seconds. */
  slings({ unit, int, chance }) {
    const turn = 2 * Math.PI * unit();
    const speed = int(40, 160);
    const first = around(START, turn + (unit() - 0.5), int(60, 200));
    const asteroids = [{ ...first, radius: 32, ...(chance(0.2) && { hot: true }) }];
    if (chance(0.5)) asteroids.push({ ...around(first, turn + (unit() - 0.5) * 2, int(150, 400)), radius: 16 });
    const blackHole = around(first, turn + (unit() - 0.5) * 3, int(80, 240));
    const novae = Array.from({ length: int(0, 12) }, () => ({
      ...around(first, 2 * Math.PI * unit(), int(70, 260)),
      radius: chance(0.5) ? 16 : 32,
    }));
    const velocity = { vx: Math.round(speed * Math.cos(turn)), vy: Math.round(speed * Math.sin(turn)) };
    return { astronaut: { ...START, ...velocity }, blackHole, asteroids, novae };
  },
  /** Small asteroids that come towards her, with a few novae. */
  recoil({ unit, int, chance }) {
    const asteroids = [{ ...around(START, 2 * Math.PI * unit(), int(50, 220)), radius: 16 }];
    for (let more = int(0, 4); more > 0; more--) {
      asteroids.push({
        ...around(asteroids[asteroids.length - 1], 2 * Math.PI * unit(), int(120, 320)),
        radius: chance(0.7) ? 16 : 32,
      });
    }
    const blackHole = around(asteroids[asteroids.length - 1], 2 * Math.PI * unit(), int(60, 240));
    const novae = Array.from({ length: int(2, 25) }, () => ({
      x: START.x + int(-500, 500),
      y: START.y + int(-500, 500),
      radius: chance(0.5) ? 16 : 32,
    })).filter(({ x, y }) => Math.hypot(x - START.x, y - START.y) > 70);
    const moving = chance(0.3) && { vx: int(-40, 40), vy: int(-40, 40) };
    return { astronaut: { ...START, ...moving }, blackHole, recoil: true, asteroids, novae };
  },
  /** Asteroids and novae on a square lattice, like levels drawn with snapping on. */
  lattices({ unit, int, chance }) {
    const step = 20 * int(4, 8);
    const cells = Array.from({ length: 49 }, (_, i) => ({
      x: START.x + step * ((i % 7) - 3),
      y: START.y + step * (Math.floor(i / 7) - 3),
    }));
    const asteroids: { x: number; y: number; radius: number }[] = [];
    const novae: { x: number; y: number; radius: number }[] = [];
    const free: Place[] = [];
    for (const cell of cells) {
      if (cell.x === START.x && cell.y === START.y) continue;
      const drawn = unit();
      if (drawn < 0.14) asteroids.push({ ...cell, radius: 16 });
      else if (drawn < 0.5) novae.push({ ...cell, radius: chance(0.5) ? 16 : 32 });
      else free.push(cell);
    }
    if (asteroids.length === 0) asteroids.push({ ...free.splice(int(0, free.length - 1), 1)[0], radius: 16 });
    return { astronaut: { ...START }, blackHole: free[int(0, free.length - 1)], asteroids, novae };
  },
  /** Aliens and repulsors between the start and the black hole. */
  lures({ unit, int, chance }) {
    const turn = 2 * Math.PI * unit();
    const asteroids = [{ ...around(START, turn, int(80, 180)), radius: 32 }];
    for (let more = int(0, 3); more > 0; more--) {
      asteroids.push({ ...around(asteroids[asteroids.length - 1], turn + unit() - 0.5, int(140, 260)), radius: 16 });
    }
    const last = asteroids[asteroids.length - 1];
    const blackHole = around(last, turn + 2 * unit() - 1, int(60, 200));
    const aliens = Array.from({ length: int(1, 3) }, () => around(last, 2 * Math.PI * unit(), int(60, 220)));
    const repulsors = Array.from({ length: int(0, 3) }, () => ({
      ...around(last, 2 * Math.PI * unit(), int(60, 200)),
      radius: 48,
    }));
    const novae = Array.from({ length: int(0, 8) }, () => ({ ...around(last, 2 * Math.PI * unit(), int(90, 240)), radius: 16 }));
    const moving = chance(0.4) && { vx: int(-60, 60), vy: int(-60, 60) };
    return { astronaut: { ...START, ...moving }, blackHole, asteroids, aliens, repulsors, novae };
  },
};

/**
 * One level of a set of small levels in the styles that designers compose in, the same on every machine. Nothing is solved and
 * no level is rejected, so many have no solution.
 */
export function styledLevel(seed: number): LevelFile {
  const unit = seeded(0x57e1 + 7919 * seed);
  const dice: Dice = {
    unit,
    int: (least, most) => least + Math.floor(unit() * (most - least + 1)),
    chance: (p) => unit() < p,
  };
  return { version: LEVEL_VERSION, name: `${styleOf(seed)} ${seed}`, ...COMPOSE[styleOf(seed)](dice) };
}
