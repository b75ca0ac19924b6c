import { compile, createSimulation, playScript, STATE_SIZE } from '../../../engine/index.ts';
import { type Hold, type Level, NO_OBJECTS } from '../../../schema/index.ts';
import { verifyRun } from '../../../solver/index.ts';
import { seeded } from '../seeded.ts';
import type { Chain } from './chain.ts';

const RANGE = 250;
const HOLE = 18;

/** The longest run that is tried, ticks. */
const LONGEST = 1800;

/** The run takes longer than this, ticks, so that it is a swing and no fall. */
const LEAST = 400;

/**
 * A level with one asteroid and a black hole beyond the edge of the range. Her box can touch it only in the last tick before she is
 * lost, and only at one place of the edge, where it is turned so that it reaches out. The same arguments give the same level on every
 * machine.
 *
 * A run is played first: random presses that carry her out of the range. Beyond her last place in range stands the hole, so that her
 * box overlaps it there by `depth`.
 *
 * @param depth px
 * @throws {Error} if no run was found to build around
 */
export function makeGrazing(depth: number, seed: number): Chain {
  const random = seeded(777 * seed);
  for (let attempt = 0; attempt < 20_000; attempt++) {
    const level = emptyLevel(random);
    const holds = randomHolds(random);
    const out = lastInRange(level, holds);
    if (out === null) continue;
    const d = Math.hypot(out.x, out.y);
    const [ux, uy] = [out.x / d, out.y / d];
    // how far the box reaches outwards, along the line from the asteroid
    const reach = 10 * Math.abs(ux * out.cos + uy * out.sin) + 16 * Math.abs(uy * out.cos - ux * out.sin);
    const from = d + reach + HOLE - depth;
    const goal = { ...level, blackHole: { x: ux * from, y: uy * from, radius: HOLE } };
    if (verifyRun(compile(goal, 'precise'), holds, { minerals: 'any' }, LONGEST) === null) continue;
    return { level: goal, goal: { minerals: 'any' }, holds };
  }
  throw new Error(`expected a level whose hole is grazed by ${depth} px for seed ${seed}, found none in 20,000 attempts`);
}

/** One asteroid, and a start that moves past it. */
function emptyLevel(random: () => number): Level {
  const round = (value: number) => Math.round(value);
  return {
    name: 'grazing',
    description: '',
    astronaut: {
      x: round(-60 - random() * 120),
      y: round((random() - 0.5) * 200),
      vx: round(random() * 40),
      vy: round((random() - 0.5) * 60),
    },
    blackHole: { x: 1e5, y: 1e5, radius: HOLE },
    range: RANGE,
    recoil: false,
    ...NO_OBJECTS,
    asteroids: [{ id: null, x: 0, y: 0, radius: 16, hot: false }],
    runs: [],
  };
}

function randomHolds(random: () => number): Hold[] {
  const holds: [number, number][] = [];
  let tick = Math.floor(random() * 120);
  for (let i = 0; i < 4; i++) {
    const release = tick + 1 + Math.floor(random() * 200);
    holds.push([tick, release]);
    tick = release + 1 + Math.floor(random() * 120);
  }
  return holds;
}

/** Where she is in the last tick in range; null if she stays. */
function lastInRange(level: Level, holds: readonly Hold[]): { x: number; y: number; cos: number; sin: number } | null {
  const simulation = createSimulation(compile(level, 'precise'));
  const state = new Float64Array(STATE_SIZE);
  while (simulation.tick < LONGEST) {
    simulation.readState(state);
    const [x, y, , , cos, sin] = state;
    playScript(simulation, holds, simulation.tick + 1);
    if (simulation.ending === null) continue;
    return simulation.tick > LEAST ? { x, y, cos, sin } : null;
  }
  return null;
}
