import fc from 'fast-check';
import { expect, it } from 'vitest';
import { compile, createSimulation, playScript, STATE_SIZE, simulate } from '../../engine/index.ts';
import { expectDeep } from '../depth.ts';
import { plainLevel } from './plain-level.ts';

// In levels on a grid, events happen at ticks, and guards are 0 except for rounding.

const SECONDS = 12;

const on = (grid: number, most: number) => fc.integer({ min: -most, max: most }).map((n) => grid * n);
const at = (grid: number, most: number) => fc.record({ x: on(grid, most), y: fc.oneof(fc.constant(0), on(grid, most)) });
const circles = (radius: number, grid: number, most: number, count: number) =>
  fc.array(
    at(grid, most).map((place) => ({ ...place, radius })),
    { maxLength: count },
  );

const level = fc
  .record({
    v: fc.record({ x: on(5, 12), y: fc.oneof(fc.constant(0), on(5, 6)) }),
    repulsors: circles(48, 12, 12, 4),
    asteroids: circles(16, 10, 20, 3),
    minerals: circles(7, 10, 15, 3),
    aliens: circles(25, 20, 15, 2),
    recoil: fc.boolean(),
  })
  .map(({ v, repulsors, asteroids, minerals, aliens, recoil }) =>
    plainLevel({
      astronaut: { vx: v.x, vy: v.y },
      repulsors,
      asteroids: [{ x: 0, y: 240, radius: 16 }, ...asteroids],
      minerals,
      aliens,
      recoil,
      range: 400,
    }),
  );

const holds = fc.constantFrom<[number, number][]>([], [[0, 60]], [[60, 180]], [[120, 720]], [[0, 720]]);

it.each(['fast', 'standard', 'precise', 'arcade'] as const)(
  'a run is the same with and without recording, at once and tick by tick: %s',
  (accuracy) => {
    let crossings = 0;
    fc.assert(
      fc.property(level, holds, (of, script) => {
        const scene = compile(of, accuracy);
        const recorded = simulate(scene, script, { maxTime: SECONDS });
        crossings += recorded.events.filter(({ type }) => type === 'leave').length;
        const whole = createSimulation(scene);
        playScript(whole, script, 60 * SECONDS);
        const byTick = createSimulation(scene);
        for (let tick = 0; tick < 60 * SECONDS && byTick.ending === null; tick++) {
          byTick.advance(
            1,
            script.some(([press, release]) => press <= tick && tick < release),
          );
        }
        const [a, b, c] = [new Float64Array(STATE_SIZE), new Float64Array(STATE_SIZE), new Float64Array(STATE_SIZE)];
        recorded.trajectory.at(recorded.time, a);
        whole.readState(b);
        byTick.readState(c);
        expect([whole.ending?.outcome ?? 'timeout', whole.ending?.time ?? SECONDS]).toEqual([recorded.outcome, recorded.time]);
        expect([...b]).toEqual([...a]);
        expect(byTick.ending).toEqual(whole.ending);
        expect([...c]).toEqual([...b]);
      }),
      { numRuns: 40 },
    );
    if (accuracy !== 'arcade') expectDeep(crossings).toBeGreaterThan(20);
  },
);
