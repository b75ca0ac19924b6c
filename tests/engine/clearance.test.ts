import fc from 'fast-check';
import { expect, it } from 'vitest';
import { boxCircleGap, compile, DEFAULT_BOX, type Run, STATE_SIZE, simulate } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import { expectDeep } from '../depth.ts';
import { GRAZED_AT, graze } from '../judges/contacts.ts';
import { randomScene } from '../scenes/random-scene.ts';
import { plainLevel } from './plain-level.ts';

/** The distance to the nearest hazard at a time, px. */
function nearestHazard(level: Level, run: Run, time: number): number {
  const state = new Float64Array(STATE_SIZE);
  const aliens = new Float64Array(3 * level.aliens.length);
  const rocks = new Float64Array(2 * level.asteroids.length);
  run.trajectory.at(time, state);
  run.trajectory.aliensAt(time, aliens);
  run.trajectory.asteroidsAt(time, rocks);
  const [x, y, , , cos, sin] = state;
  const gap = (cx: number, cy: number, r: number) => boxCircleGap(DEFAULT_BOX, cx - x, cy - y, cos, sin, r);
  return Math.min(
    ...level.novae.map((o) => gap(o.x, o.y, o.radius)),
    ...level.asteroids.map((o, i) => (o.hot ? gap(rocks[2 * i], rocks[2 * i + 1], o.radius) : Number.POSITIVE_INFINITY)),
    ...level.aliens.map((o, i) =>
      aliens[3 * i + 2] === 0 ? Number.POSITIVE_INFINITY : gap(aliens[3 * i], aliens[3 * i + 1], o.radius),
    ),
  );
}

it('the clearance is reached at its time, and she is never nearer', () => {
  let looked = 0;
  fc.assert(
    fc.property(fc.nat(2 ** 31 - 1), fc.constantFrom(...GRAZED_AT), (seed, accuracy) => {
      const { level, holds, maxTime } = randomScene(seed);
      const run = simulate(compile(level, accuracy), holds, { maxTime: Math.min(maxTime, 10) });
      const { clearance } = run;
      if (clearance === null) return;
      const rounding = 1e-10 + 4e-15 * (Math.abs(level.astronaut.x) + Math.abs(level.astronaut.y));
      // where the box turns instantly, both states are right
      const turns = run.events.some((e) => Math.abs(e.time - clearance.time) < 1e-9);
      if (!turns) expect(Math.abs(nearestHazard(level, run, clearance.time) - clearance.distance)).toBeLessThan(rounding);
      expect(clearance.distance <= 0).toBe(run.outcome === 'collided' || clearance.distance === 0);
      let least = Number.POSITIVE_INFINITY;
      for (let i = 0; i <= 1000; i++) least = Math.min(least, nearestHazard(level, run, (run.time * i) / 1000));
      for (const e of run.events) least = Math.min(least, nearestHazard(level, run, e.time));
      if (least > 0 || run.outcome === 'collided')
        expect(clearance.distance).toBeLessThanOrEqual(Math.max(0, least) + 1e-6 + rounding);
      looked++;
    }),
    { numRuns: 60, endOnFailure: true },
  );
  expectDeep(looked).toBeGreaterThan(20);
});

it('the clearance is found however briefly she is that near', () => {
  let thin = 0;
  fc.assert(
    fc.property(fc.nat(2 ** 31 - 1), fc.constantFrom(...GRAZED_AT), (seed, accuracy) => {
      const made = graze(seed, accuracy);
      if (made === null || made.kind !== 'nova' || made.depth > 0 || made.gap(0) < 1e-6) return;
      const run = simulate(compile(made.level, accuracy), made.holds, { maxTime: made.until });
      if (run.outcome === 'collided' || run.clearance === null) return;
      expect(run.clearance.distance).toBeGreaterThanOrEqual(0);
      // the run ends at a tick, or before
      if (made.nearest > run.time) return;
      expect(run.clearance.distance).toBeLessThanOrEqual(-made.depth + 1e-6);
      thin++;
    }),
    { numRuns: 400, endOnFailure: true },
  );
  expectDeep(thin).toBeGreaterThan(4);
});

it('the clearance includes asteroids that drift because of recoil', () => {
  let passes = 0;
  fc.assert(
    fc.property(
      fc.constantFrom(...GRAZED_AT),
      fc.integer({ min: 6, max: 40 }),
      fc.double({ min: 1, max: 6, noNaN: true }),
      fc.double({ min: 150, max: 400, noNaN: true }),
      fc.double({ min: 40, max: 120, noNaN: true }),
      (accuracy, ticks, vy, x, beside) => {
        // the nova is near at the start; later, in one long coast, the asteroid comes nearer
        const level = plainLevel({
          recoil: true,
          range: 1000,
          astronaut: { vy },
          asteroids: [{ x, y: 0, radius: 0.01, hot: true }],
          novae: [{ x: 0, y: -beside, radius: 16 }],
        });
        const run = simulate(compile(level, accuracy), [[0, ticks]], { maxTime: 40 });
        if (run.outcome === 'collided' || run.clearance === null) return;
        let least = Number.POSITIVE_INFINITY;
        for (let i = 0; i <= 1000; i++) least = Math.min(least, nearestHazard(level, run, (run.time * i) / 1000));
        expect(run.clearance.distance).toBeLessThanOrEqual(least + 1e-6);
        if (run.clearance.kind === 'asteroid') passes++;
      },
    ),
    { numRuns: 60 },
  );
  expectDeep(passes).toBeGreaterThan(8);
});
