import { compile, createSimulation, TICK, TICK_RATE, type WorkBudget } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import { createRandom } from '../random.ts';
import { easySpeed } from './assumptions.ts';
import { startAxis, whatEnds } from './doomed.ts';
import { followPipes } from './pipe.ts';
import type { About, PipeGrid, Proof } from './proof.ts';
import { subject } from './say.ts';
import { CONTINUOUS, type Setting, type Thing } from './setting.ts';

/** Ticks a step; parts of half a turn by which sets are kept apart. */
const FRAMES = 2;
const TURNS = 8;

/** Side of a cell, px, where everything is over within a second; it grows with the horizon. */
const CELL = 3.5;

/** Sets spread with time: what goes on for longer, s, is not tried. */
const LONGEST = 2.5;

/** How much later than the longest of some plays everything may be over: a share, and s. */
const HORIZONS = [
  [1.1, 0.1],
  [1.3, 0.3],
] as const;

/** Plays that are looked at first. */
const PLAYS = 120;

/** What isn't over by so many sets, or parts of sets, is given up: a certificate has no more. */
export const MOST_PIPES = { sets: 2000, parts: 25_000 } as const;

/**
 * Whatever she presses she runs into a hazard, an alien or out of range within seconds, and comes nowhere near the thing: like `doomed`, but with her box as it
 * is turned, with aliens, and with what ties place and velocity together, so that much less is taken for possible that isn't.
 */
export function proveFlowpipe(setting: Setting, about: About, goal: Thing): Proof | null {
  const { level, rules, jump, maxTime, strongest } = setting;
  const { vx, vy } = level.astronaut;
  const fastest = Math.sqrt(vx * vx + vy * vy) + 2 * strongest * LONGEST;
  // at rest she can wait as long as she likes
  if (jump > 0 || (vx === 0 && vy === 0) || fastest > easySpeed(rules)) return null;
  const last = longestPlay(level, setting.budget);
  if (last === null) return null;
  for (const [share, more] of HORIZONS) {
    const horizon = share * last + more;
    const grid: PipeGrid = {
      axis: startAxis(setting),
      cell: CELL * Math.sqrt(Math.max(1, horizon)),
      frames: FRAMES,
      steps: Math.ceil(horizon / (FRAMES * TICK)),
      turns: TURNS,
    };
    const { closed, hopeless, layers, endedBy } = followPipes(setting, about, goal, grid, MOST_PIPES);
    if (hopeless) return null;
    if (!closed) continue;
    const seconds = Math.ceil(layers.length * grid.frames * TICK * 10) / 10;
    return {
      code: 'flowpipe',
      about,
      reason:
        `${subject(about)} is never reached: with the speed she has at the start every run ends within ${seconds} s ` +
        `at ${whatEnds(endedBy)}, whatever is pressed: start slower, elsewhere or in another direction, or clear her way`,
      covers: CONTINUOUS,
      maxTime: level.recoil ? maxTime : null,
      certificate: { kind: 'flowpipe', grid, layers },
    };
  }
  return null;
}

/** How long the longest of some plays lasts, s; null where one goes on for longer than is tried, or completes the level. */
function longestPlay(level: Level, budget: WorkBudget): number | null {
  const simulation = createSimulation(compile(level), budget);
  const random = createRandom(0);
  let longest = 0;
  for (let play = 0; play < PLAYS; play++) {
    simulation.reset();
    let held = play % 2 === 1;
    // the first two neither press nor let go
    const most = play < 2 ? LONGEST * TICK_RATE : 8 << (play % 4);
    while (simulation.ending === null && simulation.tick < LONGEST * TICK_RATE) {
      simulation.advance(play < 2 ? most : 1 + random.below(most), held);
      held = !held;
    }
    if (simulation.ending === null || simulation.ending.outcome === 'completed') return null;
    longest = Math.max(longest, simulation.ending.time);
  }
  return longest;
}
