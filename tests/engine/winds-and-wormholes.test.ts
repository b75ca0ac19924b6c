import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, type RunEvent, simulate, WorkBudget } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { expectDeep } from '../depth.ts';
import { bySmallSteps as computeBySmallSteps } from '../judges/small-steps.ts';
import { once } from '../once.ts';
import { propertySettings } from '../property-settings.ts';
import { windyScene } from '../scenes/windy-scene.ts';
import { accuracyNames, continuousNames } from './accuracies.ts';
import { plainLevel } from './plain-level.ts';

const even = (min: number, max: number) => fc.integer({ min: 0, max: 1_000_000 }).map((k) => min + ((max - min) * k) / 1e6);

const { runs } = propertySettings(process.env);

// Every accuracy is compared with the same flights.
const bySmallSteps = once(computeBySmallSteps);

/** The allowed error of each accuracy after some seconds, px. */
const ERROR = { fast: 2e-2, standard: 1e-4, precise: 1e-7 } as const;

const told = (events: readonly RunEvent[]) =>
  events.flatMap((event) => (event.type === 'effect' ? [`${event.what} ${event.index}`] : []));

describe.each(continuousNames)('winds and wormholes at %s', (accuracy) => {
  const error = ERROR[accuracy as keyof typeof ERROR];

  it('a coast in a wind is a parabola, exactly, from rim to rim', () => {
    fc.assert(
      fc.property(even(20, 120), even(-60, 60), even(-60, 60), even(10, 60), (vx, ax, ay, radius) => {
        const level: Level = {
          ...plainLevel({ astronaut: { x: 0, y: 0, vx, vy: 0 } }),
          winds: [{ id: null, x: 100, y: 0, radius, ax, ay }],
        };
        const { events, trajectory } = simulate(compile(level, accuracy), [], { maxTime: 20 });
        const enter = (100 - radius) / vx;
        expect(events[0]).toMatchObject({ type: 'effect', effect: 'winds', what: 'enter', index: 0 });
        expect(Math.abs(events[0].time - enter)).toBeLessThan(1e-12 * (1 + enter));
        const leave = events.length > 1 ? events[1].time : 20;
        const state = new Float64Array(6);
        for (const share of [0.1, 0.5, 0.9, 1]) {
          const t = share * (leave - enter);
          trajectory.at(enter + t, state);
          expect(Math.abs(state[0] - (100 - radius + vx * t + (ax * t * t) / 2))).toBeLessThan(1e-9);
          expect(Math.abs(state[1] - (ay * t * t) / 2)).toBeLessThan(1e-9);
        }
        // she leaves where the parabola meets the rim
        if (events.length > 1) {
          trajectory.at(leave, state);
          expect(Math.abs(Math.hypot(state[0] - 100, state[1]) - radius)).toBeLessThan(1e-9);
        }
      }),
      { numRuns: 40 },
    );
  });

  it('states between two ticks are between those of the ticks, long after she has left a wind', () => {
    const level: Level = {
      ...plainLevel({ astronaut: { x: 0, y: 0, vx: 60, vy: 0 }, asteroids: [{ x: 300, y: 200, radius: 16 }], range: 1000 }),
      winds: [{ id: null, x: 0, y: 0, radius: 30, ax: 100, ay: 0 }],
    };
    const { trajectory } = simulate(compile(level, accuracy), [[0, 120]], { maxTime: 2 });
    const [before, between, after] = [0, 1, 2].map(() => new Float64Array(6));
    for (let tick = 40; tick < 119; tick++) {
      trajectory.at(tick / 60, before);
      trajectory.at((tick + 0.5) / 60, between);
      trajectory.at((tick + 1) / 60, after);
      // the mean, but for what the pull changes in a tick
      for (const k of [2, 3]) expect(Math.abs(between[k] - (before[k] + after[k]) / 2)).toBeLessThan(5e-3);
    }
  });

  it('she is blown out of the exact centre of a repulsor, whatever the target', () => {
    const level: Level = {
      ...plainLevel({
        astronaut: { x: 0, y: 0, vx: 0, vy: 0 },
        asteroids: [{ x: 100, y: 0, radius: 16 }],
        repulsors: [{ x: 0, y: 0, radius: 50 }],
        range: 1000,
      }),
      winds: [{ id: null, x: 0, y: 0, radius: 400, ax: 0, ay: 10 }],
    };
    // the push and the wind, both along y: 30 t2 / 2
    const { final } = simulate(compile(level, accuracy), [[0, 60]], { maxTime: 0.5 });
    expect(final.x).toBe(0);
    expect(Math.abs(final.y - 3.75)).toBeLessThan(1e-9);
  });

  it('two asteroids at one place, one of them the target in a wind, take bounded work', () => {
    const level: Level = {
      ...plainLevel({
        astronaut: { x: 0, y: 0, vx: -19, vy: 0 },
        asteroids: [
          { x: 0, y: 0, radius: 32 },
          { x: 0, y: 0, radius: 32 },
        ],
        range: 250,
        recoil: true,
      }),
      winds: [{ id: null, x: 0, y: 0, radius: 100, ax: 0, ay: 20 }],
    };
    expect(simulate(compile(level, accuracy), [[0, 60]], { maxTime: 1, budget: new WorkBudget(2000) }).stopped).toBeNull();
  });

  it('her path agrees with small steps of another program: gun, repulsor, winds and a wormhole together', () => {
    let jumps = 0;
    fc.assert(
      fc.property(
        fc.record({
          vx: even(10, 60),
          vy: even(-40, 40),
          ax: even(-40, 40),
          ay: even(-40, 40),
          turn: even(0, 60),
          held: fc.boolean(),
        }),
        ({ vx, vy, ax, ay, turn, held }) => {
          const level: Level = {
            ...plainLevel({
              astronaut: { x: 0, y: 0, vx, vy },
              range: 2000,
              asteroids: [
                { x: 120, y: 130, radius: 16 },
                { x: 420, y: -160, radius: 16 },
              ],
              repulsors: [{ x: 150, y: -90, radius: 48 }],
            }),
            winds: [
              { id: null, x: 60, y: turn, radius: 80, ax, ay },
              { id: null, x: 330, y: -20, radius: 120, ax: 0, ay: 25 },
            ],
            wormholes: [{ id: null, x: 110, y: turn - 20, toX: 320, toY: -60, radius: 24 }],
          };
          const scene = compile(level, accuracy);
          const holds: Hold[] = held ? [[0, 180]] : [];
          const run = simulate(scene, holds, { maxTime: 3 });
          const truth = bySmallSteps(level, holds, 3, 1 / 2000);
          jumps += told(run.events).filter((what) => what.startsWith('jump')).length;
          // where a rim is nearly grazed, a small error becomes a large one
          const finer = bySmallSteps(level, holds, 3, 1 / 2700);
          const doubt = Math.hypot(finer.x - truth.x, finer.y - truth.y);
          fc.pre(doubt < 1e-8);
          expect(Math.hypot(run.final.x - truth.x, run.final.y - truth.y)).toBeLessThan(error);
        },
      ),
      { numRuns: 40 },
    );
    expectDeep(jumps).toBeGreaterThan(5);
  });

  it('a coast continues through a wormhole as if the space between had been cut out', () => {
    fc.assert(
      fc.property(even(20, 200), even(-15, 15), even(-3000, 3000), even(200, 3000), (vx, offset, dx, dy) => {
        const there = { x: 100, y: 0, toX: 100 + dx, toY: dy, radius: 20 };
        const level: Level = {
          ...plainLevel({ astronaut: { x: 0, y: offset, vx, vy: 0 } }),
          wormholes: [{ id: null, ...there }],
        };
        const time = 300 / vx;
        const { final, events } = simulate(compile(level, accuracy), [], { maxTime: time });
        expect(told(events)).toEqual(['jump 0']);
        const ticks = Math.round(time * 60) / 60;
        expect(Math.abs(final.x - (vx * ticks + dx))).toBeLessThan(1e-9 * (1 + Math.abs(final.x)));
        expect(Math.abs(final.y - (offset + dy))).toBeLessThan(1e-9 * (1 + Math.abs(final.y)));
        expect([final.vx, final.vy]).toEqual([vx, 0]);
      }),
      { numRuns: 40 },
    );
  });

  it('a wormhole does not fire again before she has left the mouth she is in', () => {
    // the exit is on the path to the entrance: she leaves the one and reaches the other again and again
    const level: Level = {
      ...plainLevel({ astronaut: { x: 0, y: 0, vx: 60, vy: 0 } }),
      wormholes: [{ id: null, x: 200, y: 0, toX: 100, toY: 0, radius: 20 }],
    };
    const { events } = simulate(compile(level, accuracy), [], { maxTime: 10 });
    // into (100, 0) at 80: out at 180 = the rim of (200, 0), in which she is; through it, and free
    expect(told(events)).toEqual(['jump 0']);
  });

  it('mouths in the same place, and mouths that touch, let her go', () => {
    for (const toX of [100, 100 + 1e-9, 140, 60, 120]) {
      const level: Level = {
        ...plainLevel({ astronaut: { x: 0, y: 0, vx: 60, vy: 0 } }),
        wormholes: [{ id: null, x: 100, y: 0, toX, toY: 0, radius: 20 }],
      };
      const { work, stopped, outcome } = simulate(compile(level, accuracy), [], { maxTime: 10, budget: new WorkBudget(2000) });
      expect({ stopped, outcome, few: work.pieces < 200 }).toEqual({ stopped: null, outcome: 'timeout', few: true });
    }
  });

  it('at the speed limit, a wind holds and releases her a bounded number of times', () => {
    for (const [vx, vy, ax, ay] of [
      [0, 1000, 14, -4],
      [1000, 412, 5, 20],
      [1000, 1000, -20, 30],
      [-1000, 300, 0, 100],
    ]) {
      const level: Level = {
        ...plainLevel({ astronaut: { x: 0, y: 0, vx, vy }, range: 5000, asteroids: [{ x: 145, y: -170, radius: 16 }] }),
        winds: [{ id: null, x: 0, y: 0, radius: 4000, ax, ay }],
      };
      const { work, stopped, trajectory } = simulate(compile(level, accuracy), [[0, 100_000]], {
        maxTime: 3,
        budget: new WorkBudget(8000),
      });
      expect({ stopped, few: work.pieces < 3000 }).toEqual({ stopped: null, few: true });
      const state = new Float64Array(6);
      for (let tick = 0; tick < 180; tick++) {
        trajectory.at(tick / 60, state);
        expect(Math.max(Math.abs(state[2]), Math.abs(state[3]))).toBeLessThan(1000 + 1e-6);
      }
    }
  });

  it('a start in a mouth does not move her', () => {
    const level: Level = { ...plainLevel(), wormholes: [{ id: null, x: 3, y: 0, toX: 500, toY: 0, radius: 20 }] };
    expect(simulate(compile(level, accuracy), [], { maxTime: 2 }).final).toMatchObject({ x: 0, y: 0 });
  });

  it('she rests in the centre of the target against a wind weaker than the pull, and is blown out by a stronger one', () => {
    const windy = (ax: number): Level => ({
      ...plainLevel({ astronaut: { x: 0, y: 0 }, range: 1000, asteroids: [{ x: 0, y: 0, radius: 16 }] }),
      winds: [{ id: null, x: 0, y: 0, radius: 400, ax, ay: 0 }],
    });
    expect(simulate(compile(windy(38), accuracy), [[0, 600]], { maxTime: 5 }).final).toMatchObject({ x: 0, y: 0 });
    const { x } = simulate(compile(windy(60), accuracy), [[0, 600]], { maxTime: 2 }).final;
    // u'' = 60 - 39 + 39 u / 1000
    const w = Math.sqrt(39 / 1000);
    expect(Math.abs(x - (21 / (w * w)) * (Math.cosh(2 * w) - 1))).toBeLessThan(error);
  });
});

describe.each(accuracyNames)('scenes with winds and wormholes at %s', (accuracy) => {
  it('stay finite, end, and give the same run again', () => {
    let effects = 0;
    for (let seed = 0; seed < 24 * runs; seed++) {
      const { level, holds } = windyScene(seed);
      const play = () => simulate(compile(level, accuracy), holds, { maxTime: 6, budget: new WorkBudget(30_000) });
      const run = play();
      effects += told(run.events).length;
      for (const value of Object.values(run.final)) expect(Number.isFinite(value)).toBe(true);
      if (run.stopped === null) expect(play().hash).toBe(run.hash);
    }
    expectDeep(effects).toBeGreaterThan(6);
  });
});
