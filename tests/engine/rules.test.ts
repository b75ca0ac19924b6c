import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  boxCircleGap,
  boxOf,
  boxOverlapsCircle,
  compile,
  createSimulation,
  STATE_SIZE,
  simulate,
  WorkBudget,
  WorkLimitReached,
} from '../../engine/index.ts';
import { DEFAULT_RULES, type Hold, type Level, type OwnRules, RULE_NAMES, resolveLevel, rulesOf } from '../../schema/index.ts';
import { expectDeep } from '../depth.ts';
import { accuracyNames, continuousNames, levelsFor } from './accuracies.ts';
import { arbitraryHolds, arbitraryPlayableLevel } from './arbitrary-level.ts';
import { arbitraryRules, CORNERS } from './arbitrary-rules.ts';
import { flipped, imageOf } from './image.ts';
import { plainLevel } from './plain-level.ts';

// Rules are data: properties that hold for the default numbers hold for any numbers within the ranges.

const withRules = (level: Level, rules: OwnRules): Level => ({ ...level, rules });
const plan = fc.array(fc.record({ ticks: fc.integer({ min: 1, max: 60 }), held: fc.boolean() }), { minLength: 1, maxLength: 6 });

const stateOf = (simulation: ReturnType<typeof createSimulation>): number[] => {
  const state = new Float64Array(STATE_SIZE);
  simulation.readState(state);
  return [...state];
};

describe.each(accuracyNames)('with its own rules, at %s', (accuracy) => {
  it('a run has the same bits however it is split', () => {
    fc.assert(
      fc.property(levelsFor(accuracy), arbitraryRules, plan, fc.integer({ min: 1, max: 13 }), (level, rules, steps, chunk) => {
        const scene = compile(withRules(level, rules), accuracy);
        const [whole, split] = [createSimulation(scene, new WorkBudget(20_000)), createSimulation(scene)];
        try {
          for (const { ticks, held } of steps) {
            whole.advance(ticks, held);
            for (let left = ticks; left > 0; left -= chunk) split.advance(Math.min(chunk, left), held);
          }
        } catch (error) {
          if (error instanceof WorkLimitReached) return;
          throw error;
        }
        expect([split.tick, split.ending, stateOf(split)]).toEqual([whole.tick, whole.ending, stateOf(whole)]);
      }),
      { numRuns: 8 },
    );
  });

  it('a run with the default rules, written or omitted, has the same hash', () => {
    fc.assert(
      fc.property(
        arbitraryPlayableLevel,
        arbitraryHolds(200),
        fc.subarray([...RULE_NAMES], { minLength: 1 }),
        (level, holds, said) => {
          const rules = Object.fromEntries(said.map((name) => [name, DEFAULT_RULES[name]]));
          const hashOf = (of: Level) => simulate(compile(of, accuracy), holds, { maxTime: 4 }).hash;
          expect(hashOf(withRules(level, rules))).toBe(hashOf(level));
        },
      ),
      { numRuns: 8 },
    );
  });

  it('numbers stay finite at every combination of limits', () => {
    const scenes = [
      plainLevel({ asteroids: [{ x: 120, y: 0, radius: 16 }], range: 250, recoil: true, novae: [{ x: 300, y: 10, radius: 16 }] }),
      plainLevel({
        astronaut: { vx: 30, vy: -5 },
        asteroids: [{ x: 100, y: 40, radius: 32 }],
        range: 300,
        repulsors: [{ x: 60, y: -20, radius: 48 }],
        aliens: [{ x: -150, y: 60, radius: 25 }],
        minerals: [{ x: 20, y: 5, radius: 7 }],
      }),
    ];
    for (const rules of CORNERS) {
      for (const level of scenes) {
        const simulation = createSimulation(compile(withRules(level, rules), accuracy), new WorkBudget(200_000));
        for (const held of [true, false, true]) simulation.advance(40, held);
        const state = stateOf(simulation);
        expect(state.every(Number.isFinite), JSON.stringify({ rules, state })).toBe(true);
        expect(Math.abs(state[4] * state[4] + state[5] * state[5] - 1)).toBeLessThan(1e-12);
      }
    }
  });

  it('no speed along an axis exceeds a changed limit', () => {
    const limits = fc.integer({ min: 10, max: 300 });
    let reached = 0;
    fc.assert(
      fc.property(arbitraryPlayableLevel, limits, fc.integer({ min: 39, max: 900 }), plan, (level, speedLimit, pull, steps) => {
        const astronaut = { ...level.astronaut, vx: 0, vy: 0 };
        const simulation = createSimulation(compile({ ...level, astronaut, rules: { speedLimit, pull } }, accuracy));
        for (const { ticks, held } of steps) {
          simulation.advance(ticks, held);
          const [, , vx, vy] = stateOf(simulation);
          expect(Math.max(Math.abs(vx), Math.abs(vy))).toBeLessThanOrEqual(speedLimit * (1 + 1e-12));
          if (Math.max(Math.abs(vx), Math.abs(vy)) > 0.999 * speedLimit) reached++;
        }
      }),
      { numRuns: 12 },
    );
    expectDeep(reached).toBeGreaterThan(2);
  });
});

describe.each(continuousNames)('in continuous time, at %s', (accuracy) => {
  it('she falls from rest as in the closed form, with any pull', () => {
    // r'' = -pull (1 - r / range): towards the end of the range the pull weakens evenly, so range - r grows as cosh
    const range = 500;
    fc.assert(
      fc.property(fc.integer({ min: 1, max: 80 }), fc.integer({ min: 150, max: 400 }), (pull, start) => {
        const level = plainLevel({ asteroids: [{ x: start, y: 0, radius: 16 }], range });
        const simulation = createSimulation(compile(withRules(level, { pull }), accuracy));
        const rate = Math.sqrt(pull / range);
        const distanceAt = (time: number) => range - (range - start) * Math.cosh(rate * time);
        let ticks = 0;
        while (ticks < 120 && distanceAt((ticks + 5) / 60) > 40) ticks += 5;
        simulation.advance(ticks, true);
        const tolerance = accuracy === 'precise' ? 1e-9 : accuracy === 'standard' ? 1e-5 : 0.05;
        expect(Math.abs(start - stateOf(simulation)[0] - distanceAt(ticks / 60))).toBeLessThan(tolerance);
      }),
      { numRuns: 25 },
    );
  });

  it('a scene and its mirror image give mirrored runs', () => {
    fc.assert(
      fc.property(arbitraryPlayableLevel, arbitraryRules, arbitraryHolds(200), (level, rules, holds: Hold[]) => {
        const play = (of: Level) =>
          simulate(compile(withRules(of, rules), accuracy), holds, { maxTime: 4, budget: new WorkBudget(50_000) });
        const [run, image] = [play(level), play(imageOf(level, flipped))];
        expect([image.outcome, image.with, image.time, image.events]).toEqual([run.outcome, run.with, run.time, run.events]);
        expect([0 - image.final.x, image.final.y + 0]).toEqual([run.final.x + 0, run.final.y + 0]);
      }),
      { numRuns: 8 },
    );
  });
});

describe('contact with a box of another size', () => {
  it('agrees with separate checks of the corners, sides and middle of the box', () => {
    /** The distance from a point to the segment between two others, px. */
    const toSegment = (px: number, py: number, ax: number, ay: number, bx: number, by: number) => {
      const [ux, uy] = [bx - ax, by - ay];
      const along = Math.min(1, Math.max(0, ((px - ax) * ux + (py - ay) * uy) / (ux * ux + uy * uy)));
      return Math.hypot(px - ax - along * ux, py - ay - along * uy);
    };
    const side = fc.integer({ min: 1, max: 200 });
    const place = fc.integer({ min: -2500, max: 2500 }).map((k) => k / 10);
    const radius = fc.integer({ min: 1, max: 600 }).map((k) => k / 10);
    fc.assert(
      fc.property(side, side, place, place, fc.integer({ min: 0, max: 628 }), radius, (boxWidth, boxHeight, dx, dy, turn, r) => {
        const box = boxOf(rulesOf({ rules: { boxWidth, boxHeight } }));
        const [cos, sin] = [Math.cos(turn / 100), Math.sin(turn / 100)];
        const corners = [
          [-1, -1],
          [1, -1],
          [1, 1],
          [-1, 1],
        ].map(([across, along]) => {
          const [x, y] = [(across * boxWidth) / 2, (along * boxHeight) / 2];
          return [x * cos - y * sin, x * sin + y * cos] as const;
        });
        // inside where it lies on the same hand of all sides
        const hands = corners.map(([ax, ay], i) => {
          const [bx, by] = corners[(i + 1) % 4];
          return (bx - ax) * (dy - ay) - (by - ay) * (dx - ax);
        });
        const rim = Math.min(...corners.map(([ax, ay], i) => toSegment(dx, dy, ax, ay, ...corners[(i + 1) % 4])));
        const gap = (hands.every((hand) => hand >= 0) ? 0 : rim) - r;
        expect(Math.abs(boxCircleGap(box, dx, dy, cos, sin, r) - gap)).toBeLessThan(1e-9);
        if (Math.abs(gap) > 1e-9) expect(boxOverlapsCircle(box, dx, dy, cos, sin, r)).toBe(gap < 0);
        expect(box.halfDiagonal).toBeGreaterThanOrEqual(Math.hypot(boxWidth, boxHeight) / 2);
      }),
      { numRuns: 200 },
    );
  });
});

describe('a level file', () => {
  const file = { version: 1, name: 'ruled', astronaut: { x: 0, y: 0 }, blackHole: { x: 100, y: 0 } } as const;

  it('with the default rules gives the same level as one without rules', () => {
    expect(resolveLevel({ ...file, rules: { pull: 39, boxHeight: 32 } })).toEqual(resolveLevel(file));
    expect(resolveLevel({ ...file, rules: { pull: 40, boxHeight: 32 } }).rules).toEqual({ pull: 40 });
  });
});
