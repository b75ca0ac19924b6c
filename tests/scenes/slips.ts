import { compile, STATE_SIZE, simulate } from '../../engine/index.ts';
import { type LevelFile, resolveLevel } from '../../schema/index.ts';
import { seeded } from './seeded.ts';

/** The slips of a designer, each by what it does to a level. */
export const SLIPS = [
  'digit mistyped',
  'digit dropped',
  'object moved',
  'asteroid deleted',
  'nova in the way',
  'wall in the way',
  'start moved',
  'speed changed',
  'range changed',
  'black hole moved',
  'radius changed',
  'rule changed',
] as const;

/** The kind of a slip. */
export type Slip = (typeof SLIPS)[number];

interface Place {
  x: number;
  y: number;
}

type Dice = { readonly unit: () => number; readonly int: (least: number, most: number) => number };

/** Writes another digit in one place of a whole number, or leaves the place out. */
function mistype(value: number, { int }: Dice, drop: boolean): number {
  const digits = String(Math.abs(Math.round(value)));
  const at = int(0, digits.length - 1);
  const other = String((Number(digits[at]) + int(1, 9)) % 10);
  const typed = digits.slice(0, at) + (drop && digits.length > 1 ? '' : other) + digits.slice(at + 1);
  return Math.sign(value || 1) * Number(typed);
}

/** All places of a level that can be moved, the start and the black hole among them. */
function placesOf(level: LevelFile): Place[] {
  const lists = [level.asteroids, level.novae, level.aliens, level.repulsors, level.minerals];
  return [level.astronaut, level.blackHole, ...lists.flatMap((list) => list ?? [])];
}

function shift(place: Place, { unit, int }: Dice, least: number, most: number): void {
  const turn = 2 * Math.PI * unit();
  const distance = int(least, most);
  place.x = Math.round(place.x + distance * Math.cos(turn));
  place.y = Math.round(place.y + distance * Math.sin(turn));
}

/** A place on the level's first run that is not too near to either end; the middle of the way when the level has no run. */
function onTheWay(level: LevelFile, { unit }: Dice): Place {
  const { astronaut, blackHole, runs } = level;
  const between = { x: (astronaut.x + blackHole.x) / 2, y: (astronaut.y + blackHole.y) / 2 };
  if (runs === undefined || runs.length === 0) return between;
  const { trajectory } = simulate(compile(resolveLevel(level)), runs[0].holds);
  const state = new Float64Array(STATE_SIZE);
  trajectory.at((0.25 + 0.65 * unit()) * trajectory.duration, state);
  const [x, y] = state;
  return { x, y };
}

/** A row of novae across the way from the start to the black hole, wide enough that few would fly around it. */
function wall(level: LevelFile, dice: Dice): { x: number; y: number; radius: number }[] {
  const { x, y } = onTheWay(level, dice);
  const { astronaut, blackHole } = level;
  const length = Math.max(1, Math.hypot(blackHole.x - astronaut.x, blackHole.y - astronaut.y));
  const across = { x: -(blackHole.y - astronaut.y) / length, y: (blackHole.x - astronaut.x) / length };
  const half = dice.int(2, 9);
  return Array.from({ length: 2 * half + 1 }, (_, i) => ({
    x: Math.round(x + across.x * (i - half) * 36),
    y: Math.round(y + across.y * (i - half) * 36),
    radius: 16,
  }));
}

const pick = <T>(list: readonly T[], { int }: Dice): T => list[int(0, list.length - 1)];

// each changes the copy that it is given
const MAKE: Readonly<Record<Slip, (level: LevelFile, dice: Dice) => void>> = {
  'digit mistyped': (level, dice) => {
    const place = pick(placesOf(level), dice);
    const axis = dice.int(0, 1) === 0 ? 'x' : 'y';
    place[axis] = mistype(place[axis], dice, false);
  },
  'digit dropped': (level, dice) => {
    const place = pick(placesOf(level), dice);
    const axis = dice.int(0, 1) === 0 ? 'x' : 'y';
    place[axis] = mistype(place[axis], dice, true);
  },
  'object moved': (level, dice) => shift(pick(placesOf(level), dice), dice, 20, 200),
  'asteroid deleted': (level, { int }) => {
    level.asteroids?.splice(int(0, level.asteroids.length - 1), 1);
  },
  'nova in the way': (level, dice) => {
    const { x, y } = onTheWay(level, dice);
    level.novae = [...(level.novae ?? []), { x: Math.round(x), y: Math.round(y), radius: dice.int(0, 1) === 0 ? 16 : 32 }];
  },
  'wall in the way': (level, dice) => {
    level.novae = [...(level.novae ?? []), ...wall(level, dice)];
  },
  'start moved': (level, dice) => shift(level.astronaut, dice, 20, 150),
  'speed changed': ({ astronaut }, { int }) => {
    const [vx, vy] = [astronaut.vx ?? 0, astronaut.vy ?? 0];
    const choice = int(0, 2);
    if (choice === 0 && (vx !== 0 || vy !== 0)) Object.assign(astronaut, { vx: -vx, vy: -vy });
    else if (choice === 1 && (vx !== 0 || vy !== 0)) Object.assign(astronaut, { vx: 3 * vx, vy: 3 * vy });
    else Object.assign(astronaut, { vx: int(-120, 120), vy: int(-120, 120) });
  },
  'range changed': (level, dice) => {
    level.range = pick([25, 50, 100, 125, 150, 200], dice);
  },
  'black hole moved': (level, dice) => shift(level.blackHole, dice, 40, 400),
  'radius changed': (level, dice) => {
    const round = [...(level.asteroids ?? []), ...(level.novae ?? []), ...(level.repulsors ?? [])];
    const one = pick(round, dice);
    if (one !== undefined) one.radius = pick([1, 8, 61, 96, 160, 320], dice);
  },
  'rule changed': (level, dice) => {
    if (dice.int(0, 1) === 0) level.recoil = level.recoil !== true;
    else for (const asteroid of level.asteroids ?? []) asteroid.hot = asteroid.hot !== true;
  },
};

/**
 * A copy of a level with one slip.
 * @param seed distinguishes slips of one kind in different levels
 */
export function slipped(level: LevelFile, slip: Slip, seed: number): LevelFile {
  const unit = seeded(0x511b + 104_729 * seed + SLIPS.indexOf(slip));
  const copy = structuredClone(level);
  MAKE[slip](copy, { unit, int: (least, most) => least + Math.floor(unit() * (most - least + 1)) });
  return copy;
}
