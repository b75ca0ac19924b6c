import {
  ACCURACIES,
  type Accuracy,
  accuracyOf,
  compile,
  createSimulation,
  joinHolds,
  playScript,
  type Run,
  type Scene,
  type Simulation,
  STATE_SIZE,
  simulate,
  TICK_RATE,
  WorkBudget,
} from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import type { RandomScene } from '../scenes/random-scene.ts';
import { seeded } from '../scenes/seeded.ts';

/** Settings besides the named ones: coarse and fine rates, both contact tests, loose and tight tolerances. */
const SETTINGS: readonly Accuracy[] = [
  ...(['euler', 'verlet', 'rk4'] as const).flatMap((integrator) =>
    [20, 60, 144].map((rate) => accuracyOf({ integrator, rate, tolerance: null, contact: 'swept' })),
  ),
  ...(['euler', 'verlet', 'rk4'] as const).map((integrator) =>
    accuracyOf({ integrator, rate: 60, tolerance: null, contact: 'frame' }),
  ),
  ...[1e-4, 1e-12].map((tolerance) => accuracyOf({ integrator: 'taylor', rate: null, tolerance, contact: 'swept' })),
];

/** Pieces of motion that a second of play may take. */
const MOST_PIECES = 60_000;

/**
 * Plays a scene whole, in parts, tick by tick and recorded, at every named accuracy and at a custom setting.
 * @param seed - chooses the parts and the custom setting
 */
export function checkParts({ level, holds, maxTime }: RandomScene, seed: number): { accuracy: string; what: string }[] {
  const custom = SETTINGS[seed % SETTINGS.length];
  return [...Object.values<Accuracy>(ACCURACIES), custom].flatMap((accuracy) => {
    const found = (what: string) => ({ accuracy: accuracy.name, what });
    try {
      const scene = compile(level, accuracy);
      const limited = () => new WorkBudget(MOST_PIECES * maxTime);
      const run = simulate(scene, holds, { maxTime, budget: limited() });
      if (run.stopped !== null) return [found(`takes more than ${MOST_PIECES} pieces a second, up to ${run.time} s`)];
      return differencesInParts(scene, run, holds, maxTime, seed, limited).map(found);
    } catch (error) {
      return [found(`throws ${error instanceof Error ? error.message : error}`)];
    }
  });
}

/**
 * Looks for differences, bit by bit, between a recorded run and the same one advanced at once, in parts and tick by tick.
 * @param seed - chooses the parts
 * @param budget - makes a budget for each run
 * @returns what differs, in words
 */
export function differencesInParts(
  scene: Scene,
  run: Run,
  holds: readonly Hold[],
  maxTime: number,
  seed: number,
  budget: () => WorkBudget | undefined,
): string[] {
  const whole = createSimulation(scene, budget());
  playScript(whole, joinHolds(holds), Math.round(maxTime * TICK_RATE));
  const seen = view(whole);
  const found: string[] = [];
  if (splitRun(scene, holds, maxTime, seed, budget) !== seen) found.push('split, with snapshots, it is another run');
  if (ticksOf(scene, holds, maxTime, budget) !== seen) found.push('tick by tick it is another run');
  if (!endsAs(run, whole, maxTime)) found.push('recorded it is another run');
  return found;
}

/** Everything that can be read of a simulation, to compare bits. */
function view(simulation: Simulation): string {
  const { level } = simulation.scene;
  const state = new Float64Array(STATE_SIZE);
  const aliens = new Float64Array(3 * level.aliens.length);
  const asteroids = new Float64Array(2 * level.asteroids.length);
  simulation.readState(state);
  simulation.readAliens(aliens);
  simulation.readAsteroids(asteroids);
  // an end on a tick belongs to the call before as well as to the one after
  const tick = simulation.ending === null ? simulation.tick : 'over';
  return [tick, JSON.stringify(simulation.ending), simulation.mineralCount, state, aliens, asteroids].join(' ');
}

/** The same run advanced in random parts; half of the time it continues in another simulation from a snapshot. */
function splitRun(
  scene: Scene,
  holds: readonly Hold[],
  maxTime: number,
  seed: number,
  budget: () => WorkBudget | undefined,
): string {
  const random = seeded(seed ^ 0x5b1175);
  const script = joinHolds(holds);
  const last = Math.round(maxTime * TICK_RATE);
  let simulation = createSimulation(scene, budget());
  let other = createSimulation(scene, budget());
  for (let tick = 0; tick < last && simulation.ending === null; ) {
    const hold = script.find(([, release]) => release > tick);
    const held = hold !== undefined && hold[0] <= tick;
    const change = hold === undefined ? last : held ? hold[1] : hold[0];
    const part = Math.min(change - tick, last - tick, 1 + Math.floor(random() * 40));
    simulation.advance(part, held);
    tick += part;
    if (random() < 0.5) continue;
    other.restore(simulation.snapshot());
    [simulation, other] = [other, simulation];
  }
  return view(simulation);
}

/** The same run advanced by single ticks. */
function ticksOf(scene: Scene, holds: readonly Hold[], maxTime: number, budget: () => WorkBudget | undefined): string {
  const simulation = createSimulation(scene, budget());
  const held = new Uint8Array(Math.round(maxTime * TICK_RATE));
  for (const [press, release] of joinHolds(holds)) held.fill(1, press, release);
  for (let tick = 0; tick < held.length && simulation.ending === null; tick++) simulation.advance(1, held[tick] === 1);
  return view(simulation);
}

/** Whether an unrecorded run ends with the bits of the recorded one. */
function endsAs(run: Run, simulation: Simulation, maxTime: number): boolean {
  const [state, recorded] = [new Float64Array(STATE_SIZE), new Float64Array(STATE_SIZE)];
  simulation.readState(state);
  run.trajectory.at(run.time, recorded);
  return (
    (simulation.ending?.outcome ?? 'timeout') === run.outcome &&
    (simulation.ending?.time ?? maxTime) === run.time &&
    state.every((value, i) => Object.is(value, recorded[i]) || value === recorded[i])
  );
}
