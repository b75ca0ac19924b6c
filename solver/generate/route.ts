import { compile, createSimulation, playScript, type Simulation, STATE_SIZE, simulate, TICK } from '../../engine/index.ts';
import type { Disc, Hold, Place } from '../../schema/basics/index.ts';
import { countOnePress } from '../difficulty/index.ts';
import type { Goal } from '../goal.ts';
import type { Random } from '../random.ts';
import { successProbability } from '../robustness/index.ts';
import { type Candidate, verifyRun } from '../verified-run.ts';
import type { GeneratorSpec } from './generator-spec.ts';
import { distance, fits, type Layout } from './layout.ts';
import { toLevel } from './level-file.ts';
import { flightOf, type Theme } from './themes/index.ts';
import { distanceToWays, forgives, type Way, wayOf } from './tube.ts';

/** A layout whose black hole lies at the end of a run. */
export interface Route {
  readonly layout: Layout;
  readonly run: Candidate;
}

const ANY: Goal = { minerals: 'any' };

// Runs that are tried before a layout is discarded, and where a theme is particular about them.
const SCRIPTS = 1000;
const THEME_SCRIPTS = 1500;

// How many suitable runs are compared. The one whose success is nearest to the wanted value is kept.
const ROUTES = 5;

const SAMPLES = 60;

// What a rank of 1 weighs, as a difference of success.
const RANK = 0.3;

// Every tenth tick suffices to see whether many single presses win.
const STRIDE = 10;

// px between the black hole and the start, at least.
const FROM_START = 160;

// px around the place of the black hole that her path must avoid before its end.
const CLEAR_OF_END = 60;

// px between her path and the edge of the level, at least.
const INSIDE = 25;

const BLACK_HOLE = 18;

// px of the grid on which a theme wants the black hole.
const GRID = 4;

/**
 * Plays random runs in a layout without a black hole, and puts the black hole at the end of one whose success is close to the
 * wanted value. From rest she falls along a straight line, on which every press leads to the same place, so runs that a single
 * press can replace do not count.
 */
export function findRoute(layout: Layout, spec: GeneratorSpec, random: Random, theme: Theme | null = null): Route | null {
  const empty = createSimulation(compile(toLevel(layout), 'arcade'));
  let best: { readonly route: Route; readonly off: number } | null = null;
  const scripts = theme === null ? SCRIPTS : THEME_SCRIPTS;
  for (let i = 0, passed = 0; i < scripts && passed < ROUTES; i++) {
    const holds = randomHolds(spec, random);
    const end = endOf(empty, layout, spec, holds, random, theme);
    if (end === null) continue;
    const ended = { ...layout, blackHole: end };
    const scene = compile(toLevel(ended), 'arcade');
    const run = verifyRun(scene, holds);
    if (run === null || run.holds.length < holds.length || verifyRun(scene, []) !== null) continue;
    const rank = theme === null ? 0 : theme.rank(scene.level, flightOf(scene, run.holds));
    if (rank === null) continue;
    const { count, tried } = countOnePress(scene, ANY, run.tick + 1, run.tick + 600, STRIDE);
    if (count > spec.onePress * tried) continue;
    const p40 = successProbability(scene, run.holds, ANY, 40, { samples: SAMPLES, seed: i }).p;
    if (p40 < spec.p40 || !forgives(scene, run.holds, spec.certifiedTicks, random)) continue;
    passed++;
    const off = Math.abs(p40 - spec.routeP40) - RANK * rank;
    if (best === null || off < best.off) best = { route: { layout: ended, run }, off };
  }
  return best?.route ?? null;
}

function randomHolds(spec: GeneratorSpec, random: Random): Hold[] {
  const [least, most] = spec.presses;
  const [shortest, longest] = spec.hold;
  const presses = least + random.below(most - least + 1);
  const holds: Hold[] = [];
  let tick = 10 + random.below(40);
  for (let i = 0; i < presses; i++) {
    const press = tick;
    tick += shortest + random.below(longest - shortest + 1);
    holds.push([press, tick]);
    tick += 10 + random.below(spec.coast);
  }
  return holds;
}

/** The place for the black hole at the end of a run; null where there is no room, or where the run does not suit. */
function endOf(
  simulation: Simulation,
  layout: Layout,
  spec: GeneratorSpec,
  holds: readonly Hold[],
  random: Random,
  theme: Theme | null,
): Disc | null {
  const tick = holds[holds.length - 1][1] + 20 + random.below(spec.coast);
  simulation.reset();
  playScript(simulation, holds, tick);
  if (simulation.ending !== null) return null;
  const state = new Float64Array(STATE_SIZE);
  simulation.readState(state);
  const grid = theme === null ? 1 : GRID;
  const end = { x: grid * Math.round(state[0] / grid), y: grid * Math.round(state[1] / grid), radius: BLACK_HOLE };
  if (distance(end, layout.start) < FROM_START || !fits(layout, spec, end)) return null;

  const { scene } = simulation;
  const { events } = simulate(scene, holds, { maxTime: tick * TICK });
  // While a single asteroid pulls, she stays on the line of her first fall.
  const targets = new Set(events.flatMap((event) => (event.type === 'target' ? [event.index] : [])));
  const moves = layout.start.vx !== 0 || layout.start.vy !== 0;
  if (targets.size < 2 && (theme === null || !moves)) return null;
  const way = wayOf(scene, holds, tick);
  if (!way.every((place) => isInside(spec, place))) return null;
  // Only the last stretch may come near the black hole; otherwise she would reach it too early.
  const before: Way = way.filter((place, i) => i < way.length / 2 || distance(place, end) > 2 * CLEAR_OF_END);
  return distanceToWays([before], end) < CLEAR_OF_END ? null : end;
}

const isInside = ({ width, height }: GeneratorSpec, { x, y }: Place): boolean =>
  x > INSIDE && y > INSIDE && x < width - INSIDE && y < height - INSIDE;
