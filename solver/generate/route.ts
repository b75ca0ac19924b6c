import { compile, createSimulation, playScript, type Simulation, STATE_SIZE, simulate, TICK } from '../../engine/index.ts';
import type { Disc, Hold, Place } from '../../schema/index.ts';
import { countOnePress } from '../difficulty/index.ts';
import type { Goal } from '../goal.ts';
import type { Random } from '../random.ts';
import { successProbability } from '../robustness/index.ts';
import { type Candidate, verifyRun } from '../verified-run.ts';
import type { GeneratorSpec } from './generator-spec.ts';
import { distance, fits, type Layout } from './layout.ts';
import { toLevel } from './level-file.ts';
import { distanceToWays, forgives, type Way, wayOf } from './tube.ts';

/** A way through a layout, and the layout with a black hole at its end. */
export interface Route {
  readonly layout: Layout;
  readonly run: Candidate;
}

const ANY: Goal = { minerals: 'any' };

// scripts played before a layout is given up
const SCRIPTS = 1000;

// ways that would do, of which the one nearest to the wanted P is kept
const ROUTES = 5;

const SAMPLES = 60;

// every tenth tick is enough to see that many single presses do it
const STRIDE = 10;

// px between the black hole and the start
const FROM_START = 160;

// px within which the way must not pass where the black hole will be, before it gets there
const CLEAR_OF_END = 60;

// px that she stays away from the edge
const INSIDE = 25;

const BLACK_HOLE = 18;

/**
 * Plays a layout without a black hole at random, and puts one at the end of a way that forgives neither too little nor too much.
 * From rest she falls on a straight line, where every press leads to the same place: ways that a single press finds don't count.
 */
export function findRoute(layout: Layout, spec: GeneratorSpec, random: Random): Route | null {
  const empty = createSimulation(compile(toLevel(layout), 'arcade'));
  let best: { readonly route: Route; readonly off: number } | null = null;
  for (let i = 0, passed = 0; i < SCRIPTS && passed < ROUTES; i++) {
    const holds = randomHolds(spec, random);
    const end = endOf(empty, layout, spec, holds, random);
    if (end === null) continue;
    const ended = { ...layout, blackHole: end };
    const scene = compile(toLevel(ended), 'arcade');
    const run = verifyRun(scene, holds);
    if (run === null || run.holds.length < holds.length || verifyRun(scene, []) !== null) continue;
    const { count, tried } = countOnePress(scene, ANY, run.tick + 1, run.tick + 600, STRIDE);
    if (count > spec.onePress * tried) continue;
    const p40 = successProbability(scene, run.holds, ANY, 40, { samples: SAMPLES, seed: i }).p;
    if (p40 < spec.p40 || !forgives(scene, run.holds, spec.certifiedTicks, random)) continue;
    passed++;
    const off = Math.abs(p40 - spec.routeP40);
    if (best === null || off < best.off) best = { route: { layout: ended, run }, off };
  }
  return best?.route ?? null;
}

function randomHolds(spec: GeneratorSpec, random: Random): Hold[] {
  const [least, most] = spec.presses;
  const presses = least + random.below(most - least + 1);
  const holds: Hold[] = [];
  let tick = 10 + random.below(40);
  for (let i = 0; i < presses; i++) {
    const press = tick;
    tick += 20 + random.below(140);
    holds.push([press, tick]);
    tick += 10 + random.below(spec.coast);
  }
  return holds;
}

/** Where the black hole could stand at the end of a script's way; null where there is no room or she does not get there in good order. */
function endOf(simulation: Simulation, layout: Layout, spec: GeneratorSpec, holds: readonly Hold[], random: Random): Disc | null {
  const tick = holds[holds.length - 1][1] + 20 + random.below(spec.coast);
  simulation.reset();
  playScript(simulation, holds, tick);
  if (simulation.ending !== null) return null;
  const state = new Float64Array(STATE_SIZE);
  simulation.readState(state);
  const end = { x: Math.round(state[0]), y: Math.round(state[1]), radius: BLACK_HOLE };
  if (distance(end, layout.start) < FROM_START || !fits(layout, spec, end)) return null;

  const { scene } = simulation;
  const { events } = simulate(scene, holds, { maxTime: tick * TICK });
  // as long as one asteroid alone pulls, she stays on the line of her first fall
  const targets = new Set(events.flatMap((event) => (event.type === 'target' ? [event.index] : [])));
  if (targets.size < 2) return null;
  const way = wayOf(scene, holds, tick);
  if (!way.every((place) => isInside(spec, place))) return null;
  // the last stretch does come near; what comes before must not, or she would be there early
  const before: Way = way.filter((place, i) => i < way.length / 2 || distance(place, end) > 2 * CLEAR_OF_END);
  return distanceToWays([before], end) < CLEAR_OF_END ? null : end;
}

const isInside = ({ width, height }: GeneratorSpec, { x, y }: Place): boolean =>
  x > INSIDE && y > INSIDE && x < width - INSIDE && y < height - INSIDE;
