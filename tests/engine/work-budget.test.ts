import fc from 'fast-check';
import { describe, expect, it, vi } from 'vitest';
import {
  type AccuracyName,
  compile,
  createSimulation,
  EFFECTS,
  playScript,
  simulate,
  WorkBudget,
  WorkLimitReached,
} from '../../engine/index.ts';
import { resolveLevel } from '../../schema/index.ts';
import { itQuick } from '../depth.ts';
import { HEAVY_LEVELS } from '../scenes/heavy-levels.ts';
import { randomScene } from '../scenes/random-scene.ts';
import { plainLevel } from './plain-level.ts';

const ACCURACY = fc.constantFrom<AccuracyName>('precise', 'standard', 'fast', 'arcade');
const SEED = fc.nat(1_000_000);

describe('a budget of work', () => {
  it('lends a share of its limit, and never more than is left', () => {
    fc.assert(
      fc.property(fc.integer({ min: 0, max: 99 }), fc.double({ min: 0, max: 1, noNaN: true }), (spent, share) => {
        const budget = new WorkBudget(100);
        budget.piece(spent);
        const before = budget.looks;
        const spendAll = () => {
          for (;;) budget.look(1);
        };
        expect(() => budget.within(share, spendAll)).toThrow(WorkLimitReached);
        // the look that was too many counts as well
        expect(budget.looks).toBe(Math.floor(Math.min(1600, before + 1600 * share)) + 1);
        expect(budget.most).toBe(1600);
        expect(budget.within(share, () => 'done')).toBe('done');
      }),
    );
  });

  it('changes nothing if it suffices, and else stops the run with its reason', () => {
    fc.assert(
      fc.property(SEED, ACCURACY, fc.integer({ min: 1, max: 3000 }), (seed, accuracy, maxWork) => {
        const { level, holds, maxTime } = randomScene(seed);
        const scene = compile(level, accuracy);
        const whole = simulate(scene, holds, { maxTime });
        const limited = simulate(scene, holds, { maxTime, budget: new WorkBudget(maxWork) });
        expect(whole.stopped).toBeNull();
        if (limited.stopped === null) {
          expect([limited.outcome, limited.time, limited.events]).toEqual([whole.outcome, whole.time, whole.events]);
        } else {
          expect(limited.outcome).toBe('timeout');
          expect(limited.tick).toBeLessThanOrEqual(whole.tick);
          expect(limited.events).toEqual(whole.events.slice(0, limited.events.length));
        }
      }),
      { numRuns: 25 },
    );
  });

  itQuick('covers the search for repeated orbits to skip', () => {
    for (const share of [1, 1e-2, 1e-4, 1e-7]) {
      const across = 3e-7;
      const level = plainLevel({
        range: 1000,
        astronaut: { x: across, vy: share * Math.sqrt(39 * across) },
        asteroids: [{ x: 0, y: 0, radius: 16 }],
      });
      const budget = new WorkBudget();
      const simulation = createSimulation(compile(level, 'precise'), budget);
      simulation.advance(300, true);
      expect(simulation.work.forceEvaluations).toBeGreaterThan(5000);
      // an eighth of what pieces cost
      expect(budget.spent).toBeGreaterThan(simulation.work.forceEvaluations / 8);
    }
  });

  itQuick('an endless sequence of events at one instant is stopped, with or without a budget', () => {
    const level = plainLevel({ astronaut: { vx: 60 }, repulsors: [{ x: 100, y: 0, radius: 40 }] });
    const rule = EFFECTS.find(({ name }) => name === 'repulsor')?.events?.find(({ name }) => name === 'enter');
    if (rule === undefined) throw new Error('no such rule');
    // a faulty effect: its event changes nothing, so it is due again at once
    const fault = vi.spyOn(rule, 'fire').mockReturnValue(-1);
    try {
      const scene = compile(level, 'precise');
      expect(simulate(scene, [], { maxTime: 5 })).toMatchObject({ stopped: 'work-limit', outcome: 'timeout' });
      expect(() => createSimulation(scene).advance(300, false)).toThrow(WorkLimitReached);
      expect(() => createSimulation(scene).advance(300, false)).toThrow('events at one instant');
    } finally {
      fault.mockRestore();
    }
    expect(simulate(compile(level, 'precise'), [], { maxTime: 5 }).stopped).toBeNull();
  });

  it('is used up at the same place however the run is split', () => {
    fc.assert(
      fc.property(SEED, ACCURACY, fc.integer({ min: 1, max: 500 }), (seed, accuracy, maxWork) => {
        const { level, holds } = randomScene(seed);
        const scene = compile(level, accuracy);
        const spentBy = (): number => {
          const budget = new WorkBudget(maxWork);
          try {
            playScript(createSimulation(scene, budget), holds, 600);
          } catch (error) {
            expect(error).toBeInstanceOf(WorkLimitReached);
          }
          return budget.spent;
        };
        expect(spentBy()).toBe(spentBy());
      }),
      { numRuns: 16 },
    );
  });

  it('covers recordings, and ends a run that would exceed it', () => {
    const scene = compile(resolveLevel(HEAVY_LEVELS['tiny-orbit']()));
    const run = simulate(scene, [[0, 3600]], { budget: new WorkBudget(Number.POSITIVE_INFINITY, 100_000) });
    expect(run.stopped).toBe('work-limit');
    expect(run.work.pieces).toBeLessThan(1000);
  });

  it('is shared by consecutive runs and their evaluations', () => {
    const { level, holds } = randomScene(11);
    const budget = new WorkBudget(1e6);
    const scene = compile(level);
    const before = budget.spent;
    const run = simulate(scene, holds, { budget });
    const played = budget.spent;
    expect(played).toBeGreaterThan(before);
    expect(run.hash).toMatch(/^[0-9a-f]+$/);
    expect(budget.spent).toBeGreaterThan(played);
  });

  it('stops a run at its start if it is already used up', () => {
    const budget = new WorkBudget(0);
    for (const name of ['everything', 'recoil', 'ring-of-aliens']) {
      const level = resolveLevel(HEAVY_LEVELS[name](0.05));
      const run = simulate(compile(level), level.runs[0].holds, { budget });
      expect([run.stopped, run.outcome, run.tick, run.events]).toEqual(['work-limit', 'timeout', 0, []]);
    }
  });

  it.each(Object.keys(HEAVY_LEVELS))('ends %s, whatever the accuracy', (name) => {
    const level = resolveLevel(HEAVY_LEVELS[name](0.05));
    for (const accuracy of ['precise', 'fast', 'arcade'] as const) {
      const budget = new WorkBudget(20_000);
      for (const { holds } of level.runs.slice(0, 3)) simulate(compile(level, accuracy), holds, { budget });
      // one more piece than allowed, with everything that it evaluates at once
      expect(budget.spent).toBeLessThan(30_000);
    }
  });
});

it('a run that keeps only events has the same hash, clearance and path', () => {
  fc.assert(
    fc.property(SEED, ACCURACY, (seed, accuracy) => {
      const { level, holds, maxTime } = randomScene(seed);
      const scene = compile(level, accuracy);
      const kept = simulate(scene, holds, { maxTime });
      const not = simulate(scene, holds, { maxTime, record: false });
      expect([not.hash, not.clearance, not.trajectory.duration]).toEqual([kept.hash, kept.clearance, kept.trajectory.duration]);
      expect([not.outcome, not.events, not.final]).toEqual([kept.outcome, kept.events, kept.final]);
    }),
    { numRuns: 16 },
  );
});
