import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  ACCURACIES,
  type Accuracy,
  accuracyOf,
  compile,
  createSimulation,
  joinHolds,
  playScript,
  type RunEvent,
  type Scene,
  type Simulation,
  STATE_SIZE,
  simulate,
  WorkBudget,
  WorkLimitReached,
} from '../../engine/index.ts';
import { type Hold, NO_OBJECTS } from '../../schema/index.ts';
import { arbitraryMixedLevel } from './arbitrary-mixed-level.ts';

const TICKS = 300;

const fixed = (integrator: Accuracy['integrator'], rate: number, contact: Accuracy['contact'] = 'swept') =>
  accuracyOf({ integrator, rate, tolerance: null, contact });

const everyAccuracy: readonly Accuracy[] = [
  ...Object.values(ACCURACIES),
  fixed('euler', 60),
  fixed('euler', 90, 'frame'),
  fixed('verlet', 30),
  fixed('verlet', 240, 'frame'),
  fixed('rk4', 60, 'frame'),
  fixed('rk4', 45),
  accuracyOf({ integrator: 'taylor', rate: null, tolerance: 1e-5, contact: 'frame' }),
];

const holds = fc
  .array(fc.tuple(fc.nat(TICKS), fc.integer({ min: 1, max: 150 })), { maxLength: 3 })
  .map((list) =>
    joinHolds([[0, list.length % 2] as Hold, ...list.map(([press, length]): Hold => [press, Math.min(TICKS, press + length)])]),
  );

/** What a run can depend on later: everything, unless it is over. */
function standing(simulation: Simulation) {
  const state = new Float64Array(STATE_SIZE);
  const aliens = new Float64Array(3 * simulation.scene.aliens.count);
  const asteroids = new Float64Array(2 * simulation.scene.targets.count);
  simulation.readState(state);
  simulation.readAliens(aliens);
  simulation.readAsteroids(asteroids);
  const { ending, mineralCount } = simulation;
  return { ending, mineralCount, state, aliens, asteroids };
}

/** Plays holds in parts of at most the given lengths, in turns; continues from a snapshot in another simulation where asked. */
function playInParts(scene: Scene, script: readonly Hold[], parts: readonly number[], changesHands: boolean, budget: WorkBudget) {
  const events: RunEvent[] = [];
  let simulation = createSimulation(scene, budget, events);
  let other = createSimulation(scene, budget, events);
  events.length = 0;
  for (let tick = 0, n = 0; tick < TICKS && simulation.ending === null; n++) {
    const hold = script.find(([, release]) => release > tick);
    const held = hold !== undefined && hold[0] <= tick;
    const change = hold === undefined ? TICKS : held ? hold[1] : hold[0];
    const part = Math.min(change, TICKS, tick + parts[n % parts.length]) - tick;
    simulation.advance(part, held);
    tick += part;
    if (!changesHands || n % 3 !== 0) continue;
    other.restore(simulation.snapshot());
    [simulation, other] = [other, simulation];
  }
  return { seen: standing(simulation), events };
}

/** @throws an assertion error unless a run is the same at once, by ticks, in parts, with and without a recording */
function expectOneResult(scene: Scene, script: readonly Hold[], parts: readonly number[]): void {
  const play = (lengths: readonly number[], changesHands: boolean) =>
    unlessTooLong(() => playInParts(scene, script, lengths, changesHands, new WorkBudget(20_000)));
  const whole = play([TICKS], false);
  expect(play([1], false)).toEqual(whole);
  expect(play(parts, false)).toEqual(whole);
  expect(play(parts, true)).toEqual(whole);
  // without a recording and without listeners, more may be skipped
  const silent = createSimulation(scene);
  playScript(silent, script, TICKS);
  expect(standing(silent)).toEqual(whole.seen);
  const { events, final } = simulate(scene, script, { maxTime: TICKS / 60 });
  expect(events).toEqual(whole.events);
  const { x, y, vx, vy, cos, sin } = final;
  expect(Float64Array.of(x, y, vx, vy, cos, sin)).toEqual(whole.seen.state);
}

const unlessTooLong = <T>(play: () => T): T => {
  try {
    return play();
  } catch (error) {
    fc.pre(!(error instanceof WorkLimitReached));
    throw error;
  }
};

describe.each(everyAccuracy.map((accuracy) => [accuracy.name, accuracy] as const))('a run at %s', (_name, accuracy) => {
  const partition = fc.array(fc.integer({ min: 1, max: 60 }), { minLength: 1, maxLength: 6 });

  it('has the same bits in whatever parts it is advanced, with every effect and under all rules', () => {
    fc.assert(
      fc.property(arbitraryMixedLevel, holds, partition, (level, script, parts) =>
        expectOneResult(compile(level, accuracy), script, parts),
      ),
      { numRuns: 40 },
    );
  });

  it('also where nothing but a low speed limit interrupts it', () => {
    fc.assert(
      fc.property(arbitraryMixedLevel, fc.integer({ min: 10, max: 60 }), holds, partition, (mixed, speedLimit, script, parts) => {
        const { name, description, astronaut, range, asteroids, runs, blackHole } = mixed;
        const level = { name, description, blackHole, range: Math.max(400, range), recoil: false, runs, ...NO_OBJECTS };
        const cold = asteroids.map((asteroid) => ({ ...asteroid, hot: false }));
        const rest = { ...astronaut, vx: 0, vy: 0 };
        const scene = compile({ ...level, astronaut: rest, asteroids: cold, rules: { speedLimit } }, accuracy);
        expectOneResult(scene, script, parts);
      }),
      { numRuns: 40 },
    );
  });
});
