import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, type Run, STATE_SIZE, simulate, TICK, WorkBudget } from '../../engine/index.ts';
import { DEFAULT_RULES, type Level, NO_OBJECTS } from '../../schema/index.ts';
import { accuracyNames, levelsFor } from './accuracies.ts';
import { arbitraryHolds } from './arbitrary-level.ts';
import { imageOf, upended } from './image.ts';

const LAST_TICK = 240;

/** The names of all numbers of a run that are not finite. */
function notFinite(level: Level, run: Run): string[] {
  const found: string[] = [];
  const see = (name: string, value: number) => {
    if (!Number.isFinite(value)) found.push(`${name} ${value}`);
  };
  const state = new Float64Array(STATE_SIZE);
  const aliens = new Float64Array(3 * level.aliens.length);
  for (let tick = 0; tick <= LAST_TICK; tick++) {
    run.trajectory.at(tick * TICK, state);
    run.trajectory.aliensAt(tick * TICK, aliens);
    for (const value of state) see(`state at tick ${tick}`, value);
    for (const value of aliens) see(`alien at tick ${tick}`, value);
  }
  for (const event of run.events) see(`time of ${event.type}`, event.time);
  for (const [name, value] of Object.entries(run.final)) see(`final ${name}`, value);
  for (const [name, value] of Object.entries(run.clearance ?? {})) if (name !== 'kind') see(`clearance ${name}`, Number(value));
  see('time', run.time);
  see('tick', run.tick);
  see('duration', run.trajectory.duration);
  return found;
}

describe.each(accuracyNames)('any level at %s', (accuracy) => {
  it('ends with an outcome, finite numbers and events in order of time', () => {
    fc.assert(
      fc.property(levelsFor(accuracy), arbitraryHolds(LAST_TICK), (level, holds) => {
        const run = simulate(compile(level, accuracy), holds, { maxTime: LAST_TICK / 60 });
        expect(notFinite(level, run)).toEqual([]);
        expect(['completed', 'collided', 'lost', 'timeout']).toContain(run.outcome);
        expect(run.with === null).toBe(run.outcome === 'lost' || run.outcome === 'timeout');
        expect(run.time).toBeGreaterThanOrEqual(0);
        expect(run.time).toBeLessThanOrEqual(LAST_TICK / 60);
        for (let i = 1; i < run.events.length; i++) expect(run.events[i].time).toBeGreaterThanOrEqual(run.events[i - 1].time);
        for (const event of run.events) expect(event.time).toBeLessThanOrEqual(run.time);
        expect(Math.abs(run.final.vx)).toBeLessThanOrEqual(DEFAULT_RULES.speedLimit);
        expect(Math.abs(run.final.vy)).toBeLessThanOrEqual(DEFAULT_RULES.speedLimit);
        expect(Math.hypot(run.final.cos, run.final.sin)).toBeCloseTo(1, 12);
      }),
      { numRuns: accuracy === 'arcade' ? 200 : 40 },
    );
  });

  it('is the mirror image in the mirrored level, bit for bit', () => {
    fc.assert(
      fc.property(levelsFor(accuracy), arbitraryHolds(LAST_TICK), (level, holds) => {
        const run = simulate(compile(level, accuracy), holds, { maxTime: LAST_TICK / 60 });
        const image = simulate(compile(imageOf(level, upended), accuracy), holds, { maxTime: LAST_TICK / 60 });
        const { x, y, vx, vy, cos, sin } = image.final;
        expect({ x, y: 0 - y, vx, vy: 0 - vy, cos, sin: 0 - sin }).toEqual({
          ...run.final,
          y: run.final.y + 0,
          vy: run.final.vy + 0,
          sin: run.final.sin + 0,
        });
        // what is computed on demand is not copied
        expect({ ...image, final: 0, clearance: image.clearance }).toEqual({ ...run, final: 0, clearance: run.clearance });
      }),
      { numRuns: accuracy === 'arcade' ? 80 : 30 },
    );
  });

  it('stays finite if objects are on top of each other, however close', () => {
    const tiny = fc.oneof(
      fc.constant(0),
      fc.integer({ min: -323, max: 0 }).chain((e) => fc.constantFrom(Number(`1e${e}`), Number(`-1e${e}`))),
    );
    const place = fc.record({ x: tiny, y: tiny });
    const world = fc.record({ recoil: fc.boolean(), off: fc.constantFrom(0, 60, 60) });
    const list = fc.array(
      place.map((at) => ({ ...at, radius: 8, id: null })),
      { maxLength: 2 },
    );
    fc.assert(
      fc.property(
        place,
        tiny,
        tiny,
        place,
        list,
        list,
        list,
        list,
        list,
        arbitraryHolds(60),
        world,
        (at, vx, vy, hole, ...rest) => {
          const [asteroids, novae, repulsors, aliens, minerals, holds, { recoil, off }] = rest;
          const level: Level = {
            name: 'level',
            description: '',
            range: 300,
            recoil,
            astronaut: { ...at, vx, vy },
            blackHole: { ...hole, x: hole.x + 200, radius: 32 },
            ...NO_OBJECTS,
            asteroids: asteroids.map((asteroid) => ({ ...asteroid, x: asteroid.x + off, hot: false })),
            novae: novae.map((nova) => ({ ...nova, x: nova.x + 120 })),
            repulsors,
            aliens,
            minerals,
            runs: [],
          };
          // passing a centre so closely takes many fixed steps: the budget ends the run
          const budget = new WorkBudget(10_000);
          expect(notFinite(level, simulate(compile(level, accuracy), holds, { maxTime: LAST_TICK / 60, budget }))).toEqual([]);
        },
      ),
      { numRuns: 120 },
    );
  });
});
