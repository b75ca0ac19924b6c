import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, createSimulation, joinHolds, playScript, type Simulation, STATE_SIZE, simulate } from '../../engine/index.ts';
import { expectDeep } from '../depth.ts';
import { accuracyNames, continuousNames, levelsFor } from './accuracies.ts';
import { arbitraryHolds, arbitraryPlayableLevel } from './arbitrary-level.ts';
import { plainLevel } from './plain-level.ts';

const LAST_TICK = 300;

/** Everything that is visible of a simulation. */
function view(simulation: Simulation) {
  const { level } = simulation.scene;
  const state = new Float64Array(STATE_SIZE);
  const aliens = new Float64Array(3 * level.aliens.length);
  const asteroids = new Float64Array(2 * level.asteroids.length);
  simulation.readState(state);
  simulation.readAliens(aliens);
  simulation.readAsteroids(asteroids);
  return {
    tick: simulation.tick,
    ending: simulation.ending,
    minerals: simulation.mineralCount,
    collected: level.minerals.map((_, i) => simulation.isCollected(i)),
    numbers: [...state, ...aliens, ...asteroids],
  };
}

/** States of the button with the number of ticks of each. */
const plan = fc.array(fc.record({ ticks: fc.integer({ min: 1, max: 90 }), held: fc.boolean() }), { maxLength: 8 });

describe.each(accuracyNames)('a simulation at %s', (accuracy) => {
  // half of the levels are those in which a run lasts
  const level = fc.oneof(levelsFor(accuracy), arbitraryPlayableLevel);

  it('continues from a snapshot with the same bits as without the interruption', () => {
    fc.assert(
      fc.property(level, plan, plan, plan, (of, before, other, after) => {
        const scene = compile(of, accuracy);
        const simulation = createSimulation(scene);
        const play = (steps: typeof plan extends fc.Arbitrary<infer T> ? T : never) => {
          for (const { ticks, held } of steps) simulation.advance(ticks, held);
          return view(simulation);
        };
        const there = play(before);
        const snapshot = simulation.snapshot();
        const uninterrupted = play(after);
        simulation.restore(snapshot);
        expect(view(simulation)).toEqual(there);
        play(other);
        simulation.restore(snapshot);
        expect(play(after)).toEqual(uninterrupted);

        // another simulation of the same scene accepts the snapshot, too
        const fresh = createSimulation(scene);
        fresh.restore(snapshot);
        for (const { ticks, held } of after) fresh.advance(ticks, held);
        expect(view(fresh)).toEqual(uninterrupted);

        simulation.reset();
        expect(view(simulation)).toEqual(view(createSimulation(scene)));
      }),
      { numRuns: 40 },
    );
  });

  it('has the same bits after many calls of advance as after one', () => {
    fc.assert(
      fc.property(level, plan, fc.array(fc.integer({ min: 1, max: 17 }), { minLength: 1 }), (of, steps, chunks) => {
        const scene = compile(of, accuracy);
        const whole = createSimulation(scene);
        const split = createSimulation(scene);
        let k = 0;
        for (const { ticks, held } of steps) {
          let advanced = 0;
          for (let left = ticks; left > 0; ) {
            const chunk = Math.min(left, chunks[k++ % chunks.length]);
            advanced += split.advance(chunk, held);
            left -= chunk;
          }
          expect(whole.advance(ticks, held)).toBe(advanced);
        }
        expect(view(split)).toEqual(view(whole));
      }),
      { numRuns: 40 },
    );
  });

  it('advances by the requested ticks, or to the tick in which the run ends, and then no more', () => {
    fc.assert(
      fc.property(level, fc.integer({ min: 0, max: 200 }), fc.boolean(), (of, ticks, held) => {
        const simulation = createSimulation(compile(of, accuracy));
        const advanced = simulation.advance(ticks, held);
        expect(simulation.tick).toBe(advanced);
        if (simulation.ending === null) expect(advanced).toBe(ticks);
        else {
          expect(simulation.ending.tick).toBe(advanced - 1);
          const before = view(simulation);
          expect(simulation.advance(10, !held)).toBe(0);
          expect(view(simulation)).toEqual(before);
        }
      }),
      { numRuns: 40 },
    );
  });

  it('ends at the same tick as simulate, and simulating twice gives the same hash', () => {
    fc.assert(
      fc.property(level, arbitraryHolds(LAST_TICK), (of, holds) => {
        const scene = compile(of, accuracy);
        const run = simulate(scene, holds, { maxTime: LAST_TICK / 60 });
        const simulation = createSimulation(scene);
        playScript(simulation, joinHolds(holds), LAST_TICK);
        expect(simulation.ending?.outcome ?? 'timeout').toBe(run.outcome);
        expect(simulation.mineralCount).toBe(run.minerals.length);
        const state = new Float64Array(STATE_SIZE);
        simulation.readState(state);
        const { x, y, vx, vy, cos, sin } = run.final;
        expect([...state]).toEqual([x, y, vx, vy, cos, sin]);
        expect(simulate(compile(structuredClone(of), accuracy), holds, { maxTime: LAST_TICK / 60 }).hash).toBe(run.hash);
      }),
      { numRuns: 40 },
    );
  });

  it('refuses a snapshot of another scene', () => {
    fc.assert(
      fc.property(level, (of) => {
        const simulation = createSimulation(compile(of, accuracy));
        const snapshot = simulation.snapshot();
        expect(() => simulation.restore(snapshot.slice(1))).toThrow(RangeError);
        const into = new Float64Array(snapshot.length);
        expect(simulation.snapshot(into)).toBe(into);
        expect([...into]).toEqual([...snapshot]);
      }),
      { numRuns: 8 },
    );
  });
});

it.each(continuousNames)('at %s aliens chase the same way after a restore while an asteroid is dragged past her', (accuracy) => {
  let chasing = 0;
  fc.assert(
    fc.property(
      fc.double({ min: 60, max: 200, noNaN: true }),
      fc.double({ min: 0.01, max: 3, noNaN: true }),
      fc.double({ min: 20, max: 60, noNaN: true }),
      (radius, aside, ahead) => {
        const level = plainLevel({
          recoil: true,
          range: 1000,
          repulsors: [{ x: -50, y: 0, radius }],
          asteroids: [{ x: ahead, y: aside, radius: 0.01 }],
          aliens: [
            { x: -90, y: 80, radius: 4 },
            { x: 90, y: -80, radius: 4 },
          ],
        });
        const scene = compile(level, accuracy);
        const simulation = createSimulation(scene);
        const other = createSimulation(scene);
        for (let tick = 0; tick < 90 && simulation.ending === null; tick++) {
          other.restore(simulation.snapshot());
          simulation.advance(1, true);
          other.advance(1, true);
          expect(view(other)).toEqual(view(simulation));
          chasing++;
        }
      },
    ),
    { numRuns: 10 },
  );
  expectDeep(chasing).toBeGreaterThan(500);
});
