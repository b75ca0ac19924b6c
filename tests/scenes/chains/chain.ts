import { compile, createSimulation, playScript, type Simulation, STATE_SIZE } from '../../../engine/index.ts';
import { type Asteroid, type Circle, type Hold, type Level, NO_OBJECTS } from '../../../schema/index.ts';
import { type Goal, verifyRun } from '../../../solver/index.ts';
import { seeded } from '../seeded.ts';

/** The kinds of chains, see {@link makeChain}. */
export const FAMILIES = ['straight', 'alternating', 'recoil', 'aliens', 'fields', 'minerals', 'turns', 'sharp turns'] as const;

export type Family = (typeof FAMILIES)[number];

export interface Chain {
  readonly level: Level;
  readonly goal: Goal;
  /** A run that completes the level: the one that the walls were built around. */
  readonly holds: readonly Hold[];
}

/** From one wall to the next, px. */
const APART = 150;
/** How far a door of an alternating chain lies above or below the middle, at least and at most, px. */
const ASIDE = [45, 95] as const;
/** The same for a straight chain, where all doors lie near the middle, px. */
const STRAIGHT = 25;
/** How far a door of a chain of turns lies above or below the middle, px. */
const TURNED = [20, 70] as const;
/** How far before its wall the asteroid of a door stands, px; 0 for the other families. */
const BEFORE: Partial<Record<Family, number>> = { turns: 40, 'sharp turns': 75 };
/** Half the height of a door, px. Her box is 32 px high and 20 px wide, and up to 38 px across its corners. */
const HALF_DOOR = 26;
/** Walls reach this far from the middle: beyond it she is lost. */
const WALL = 320;

/** How many ways from one wall to the next are tried, and how many are kept to go on from. */
const TRIES = 4000;
const KEPT = 150;

/** The longest run, ticks: twelve doors take about a minute. */
export const LONGEST_RUN = 5400;

/** A run that passes a wall at a greater slope would need a wide door. */
const STEEPEST = 0.8;

/** Where the run passed a wall, and the pieces of the script before: [ticks, held]. */
interface Passage {
  readonly y: number;
  /** The passage of the wall before; null at the start. */
  readonly before: Passage | null;
  readonly snapshot: Float64Array;
  readonly pieces: readonly (readonly [ticks: number, held: boolean])[];
}

/**
 * A chain of `doors` walls of novae, each with one narrow gap and an asteroid in it. The same arguments give the same level on
 * every machine.
 *
 * A run is played first, among the asteroids alone: random presses from wall to wall, keeping what passes where a door is wanted.
 * Then walls are built around it, and aliens placed where the run still passes. So every chain is completable, by `holds`.
 *
 * - `straight`: all doors lie near the middle, where the asteroids are
 * - `alternating`: doors lie alternately above and below their asteroids, so a swing one way is followed by a swing the other way
 * - `recoil`: alternating, and asteroids are pulled as she is
 * - `aliens`: alternating, with an alien in every second chamber
 * - `fields`: alternating, with a repulsor in every second chamber, around which or through which the run leads
 * - `minerals`: alternating, with a mineral on the run in every second chamber; all of them have to be collected
 * - `turns`: alternating, and each asteroid stands before its wall, so that she flies on into the next chamber without its pull
 * - `sharp turns`: the same with asteroids so far before the walls that few runs pass; four doors are the most that were built
 *
 * @throws {Error} if no run was found to build around
 */
export function makeChain(family: Family, doors: number, seed: number): Chain {
  for (let attempt = 0; attempt < 50; attempt++) {
    const chain = attemptChain(family, doors, seeded(1000 * seed + attempt));
    if (chain !== null) return chain;
  }
  throw new Error(`expected a ${family} chain of ${doors} doors for seed ${seed}, found none in 50 attempts`);
}

const round = Math.round;

function attemptChain(family: Family, doors: number, random: () => number): Chain | null {
  const between = (least: number, most: number) => round(least + random() * (most - least));
  const first = random() < 0.5 ? 1 : -1;
  /** 1 where the way is low, -1 where it is high, 0 where it is in the middle. */
  const sideOf = (wall: number) => (family === 'straight' || wall === doors ? 0 : wall % 2 === 0 ? first : -first);
  const before = BEFORE[family] ?? 0;
  const asteroids = Array.from(
    { length: doors },
    (_, i): Asteroid => ({ id: null, x: wallAt(i) - before + between(-10, 10), y: between(-15, 15), radius: 16, hot: false }),
  );
  const repulsors =
    family === 'fields'
      ? everySecond(doors).map((i): Circle => ({ id: null, x: wallAt(i) - APART / 2, y: between(-70, 70), radius: 32 }))
      : [];
  const open: Level = {
    name: `${family}-${doors}`,
    description: '',
    astronaut: { x: wallAt(-1) + 30, y: sideOf(0) * 60 + between(-15, 15), vx: between(25, 40), vy: 0 },
    blackHole: { x: 1e5, y: 1e5, radius: 18 },
    range: 250,
    recoil: family === 'recoil',
    ...NO_OBJECTS,
    asteroids,
    repulsors,
    runs: [],
  };
  const [least, most] = before > 0 ? TURNED : ASIDE;
  const passages = walk(open, doors + 1, random, (i, y) => {
    if (i === doors) return Math.abs(y) < ASIDE[1];
    const side = sideOf(i);
    return side === 0 ? Math.abs(y) < STRAIGHT : side * y > least && side * y < most;
  });
  if (passages === null) return null;
  const last = passages[doors];
  const holds = holdsOf(last.pieces);
  const level: Level = {
    ...open,
    blackHole: { x: wallAt(doors), y: round(last.y), radius: 18 },
    novae: passages.slice(0, doors).flatMap(({ y }, i) => wall(wallAt(i), round(y))),
  };
  if (verifyRun(compile(level, 'precise'), holds, undefined, LONGEST_RUN) === null) return null;
  if (family === 'minerals') return { level: withMinerals(level, holds, doors), goal: { minerals: 'all' }, holds };
  return { level: family === 'aliens' ? withAliens(level, holds, doors, random) : level, goal: { minerals: 'any' }, holds };
}

/** The chambers that hold an alien, a repulsor or a mineral. */
const everySecond = (doors: number): number[] =>
  Array.from({ length: doors }, (_, chamber) => chamber).filter((chamber) => chamber % 2 === 1);

/** The x of the i-th wall. */
const wallAt = (i: number) => i * APART;

/** A run through all walls, each passed where `isWanted` says; null when none was found. */
function walk(
  level: Level,
  walls: number,
  random: () => number,
  isWanted: (wall: number, y: number) => boolean,
): readonly Passage[] | null {
  const simulation = createSimulation(compile(level, 'precise'));
  let passages: Passage[] = [{ y: 0, before: null, snapshot: simulation.snapshot(), pieces: [] }];
  for (let i = 0; i < walls; i++) {
    const next: Passage[] = [];
    for (let tries = 0; tries < TRIES && next.length < KEPT; tries++) {
      const passage = tryPassage(simulation, passages[Math.floor(random() * passages.length)], wallAt(i), random);
      if (passage !== null && isWanted(i, passage.y)) next.push(passage);
    }
    if (next.length === 0) return null;
    passages = next;
  }
  const path: Passage[] = [];
  for (let one: Passage = passages[0]; one.before !== null; one = one.before) path.push(one);
  return path.reverse();
}

/** Random presses until she passes the wall at `x`; null when she does not, or not across it. */
function tryPassage(simulation: Simulation, from: Passage, x: number, random: () => number): Passage | null {
  simulation.restore(from.snapshot);
  const state = new Float64Array(STATE_SIZE);
  const pieces: [number, boolean][] = [];
  for (let part = 0, held = random() < 0.5; part < 6; part++, held = !held) {
    const ticks = 1 + Math.floor(random() * random() * (held ? 240 : 120));
    pieces.push([0, held]);
    for (let i = 0; i < ticks; i++) {
      simulation.advance(1, held);
      pieces[part][0]++;
      if (simulation.ending !== null || simulation.tick > LONGEST_RUN - 400) return null;
      simulation.readState(state);
      if (state[0] < x) continue;
      // a gap lets her through only if she flies across the wall rather than along it
      if (Math.abs(state[3]) > STEEPEST * state[2]) return null;
      return { y: state[1], before: from, snapshot: simulation.snapshot(), pieces: [...from.pieces, ...pieces] };
    }
  }
  return null;
}

/** Joins the pieces of a script. */
function holdsOf(pieces: Passage['pieces']): Hold[] {
  const holds: [number, number][] = [];
  let tick = 0;
  for (const [ticks, held] of pieces) {
    const last = holds.at(-1);
    if (held && last !== undefined && last[1] === tick) last[1] += ticks;
    else if (held) holds.push([tick, tick + ticks]);
    tick += ticks;
  }
  return holds;
}

/** Novae above and below a gap around `y`, without another gap between them. */
function wall(x: number, y: number, half = HALF_DOOR): Circle[] {
  const novae: Circle[] = [];
  for (const side of [-1, 1]) {
    let edge = y + side * half;
    while (side * edge < WALL) {
      const radius = Math.abs(edge - y) > half + 60 ? 32 : 16;
      novae.push({ id: null, x, y: edge + side * radius, radius });
      edge += side * (2 * radius - 2);
    }
  }
  return novae;
}

/** The level with an alien in every second chamber, where `holds` still complete it. */
function withAliens(level: Level, holds: readonly Hold[], doors: number, random: () => number): Level {
  let populated = level;
  for (const chamber of everySecond(doors)) {
    for (let tries = 0; tries < 40; tries++) {
      const x = round(wallAt(chamber) - APART / 2 + (random() - 0.5) * 40);
      const y = round((random() - 0.5) * 360);
      const more: Level = { ...populated, aliens: [...populated.aliens, { id: null, x, y, radius: 25 }] };
      if (verifyRun(compile(more, 'precise'), holds, undefined, LONGEST_RUN) === null) continue;
      populated = more;
      break;
    }
  }
  return populated;
}

/** The level with a mineral where `holds` first reach the middle of every second chamber. */
function withMinerals(level: Level, holds: readonly Hold[], doors: number): Level {
  const simulation = createSimulation(compile(level, 'precise'));
  const state = new Float64Array(STATE_SIZE);
  const minerals: Circle[] = [];
  for (const chamber of everySecond(doors)) {
    do {
      playScript(simulation, holds, simulation.tick + 1);
      simulation.readState(state);
    } while (state[0] < wallAt(chamber) - APART / 2);
    minerals.push({ id: null, x: round(state[0]), y: round(state[1]), radius: 7 });
  }
  return { ...level, minerals };
}

/**
 * A chain whose asteroids lie exactly in the middle between the walls. Each chamber is the mirror image of the one before.
 *
 * It gets harder with every door and cannot go on for ever, since neither a hold nor a drift changes the angular momentum about
 * the nearest asteroid, and the border between two asteroids is the wall. Let w be the width of a chamber. She leaves a chamber
 * at distance q from the middle, on the side where the next door is not, with the velocity (v, u), u pointing away from the
 * middle. Then the angular momentum is L = u w / 2 - q v, and about the next asteroid -(u w / 2 + q v): in the mirrored chamber it
 * has grown by 2 q v. So u / v = (L / v + q) / (w / 2), and L grows at each door. Her box fits through a door up to some slope only,
 * which takes speeds that grow geometrically. But she gains no more than a certain energy in a chamber.
 */
export function makeMirrored(doors: number): Level {
  const wide = 200;
  const aside = 30;
  const side = (i: number) => (i % 2 === 0 ? -1 : 1);
  return {
    name: `mirrored-${doors}`,
    description: '',
    astronaut: { x: -wide / 2, y: aside, vx: 45, vy: 0 },
    blackHole: { x: doors * wide + 60, y: 0, radius: 18 },
    range: 250,
    recoil: false,
    ...NO_OBJECTS,
    asteroids: Array.from({ length: doors + 1 }, (_, i) => ({ id: null, x: i * wide, y: 0, radius: 16, hot: false })),
    novae: Array.from({ length: doors }, (_, i) => wall((i + 0.5) * wide, side(i) * aside, 30)).flat(),
    runs: [],
  };
}
