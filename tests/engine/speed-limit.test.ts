import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, STATE_SIZE, simulate, WorkBudget } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import { expectDeep } from '../depth.ts';
import { once } from '../once.ts';
import { continuousNames } from './accuracies.ts';
import { limitedFlight } from './limited-flight.ts';
import { plainLevel } from './plain-level.ts';

const LIMIT = 1000;
const RANGE = 1e5;

type State = readonly [x: number, y: number, vx: number, vy: number];

/** The pull of one asteroid at 0, 0; along x, the limit may cancel it. */
function rates([x, y, vx, vy]: State, held: boolean): State {
  const d = Math.hypot(x, y);
  const a = -39 * (1 / d - 1 / RANGE);
  return [vx, vy, held ? 0 : a * x, a * y];
}

/** A step of the classical Runge-Kutta method. */
function step(s: State, h: number, held: boolean): State {
  const shifted = (k: State, f: number): State => [s[0] + f * k[0], s[1] + f * k[1], s[2] + f * k[2], s[3] + f * k[3]];
  const a = rates(s, held);
  const b = rates(shifted(a, h / 2), held);
  const c = rates(shifted(b, h / 2), held);
  const d = rates(shifted(c, h), held);
  const mean = (i: 0 | 1 | 2 | 3) => s[i] + (h / 6) * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
  return [mean(0), mean(1), mean(2), mean(3)];
}

const STEPS = 5000;

/**
 * Flies from the left past the asteroid, pulled towards it, for `seconds`.
 * @param limited whether the limit applies; it holds her until the pull reverses above the asteroid
 * @returns the last state, the largest vx, and the time at which the limit is reached (s, -1: never)
 */
function fly(start: State, seconds: number, limited: boolean): { end: State; fastest: number; reached: number } {
  let s = start;
  let fastest = s[2];
  let reached = -1;
  const h = seconds / STEPS;
  for (let n = 0; n < STEPS; n++) {
    const next = step(s, h, false);
    fastest = Math.max(fastest, next[2]);
    // the greatest velocity lies above the asteroid, between two steps
    if (s[0] < 0 && next[0] >= 0) {
      let t = -s[0] / s[2];
      for (let i = 0; i < 5; i++) t -= step(s, t, false)[0] / step(s, t, false)[2];
      fastest = Math.max(fastest, step(s, t, false)[2]);
    }
    const top = s[0] < 0 && next[0] >= 0 ? fastest : next[2];
    if (limited && reached < 0 && top > LIMIT) {
      let [a, b] = [0, next[2] > LIMIT ? h : -s[0] / s[2]];
      for (let i = 0; i < 60; i++) {
        const middle = (a + b) / 2;
        if (step(s, middle, false)[2] > LIMIT) b = middle;
        else a = middle;
      }
      reached = n * h + b;
      const held = step(s, b, false);
      // held: she moves on at the limit along x until x is 0, and from there free again
      const hold = -held[0] / LIMIT;
      let state: State = [held[0], held[1], LIMIT, held[3]];
      for (let i = 0; i < 300; i++) state = step(state, hold / 300, true);
      const rest = seconds - reached - hold;
      state = [0, state[1], LIMIT, state[3]];
      for (let i = 0; i < STEPS; i++) state = step(state, rest / STEPS, false);
      return { end: state, fastest, reached };
    }
    s = next;
  }
  return { end: s, fastest, reached };
}

describe('the speed limit along an axis', () => {
  it('acts on time however little she would exceed it, and holds her until the force reverses', () => {
    const counts = { held: 0, free: 0 };
    fc.assert(
      fc.property(
        fc.record({
          x: fc.double({ min: -400, max: -100, noNaN: true }),
          y: fc.double({ min: 60, max: 300, noNaN: true }),
          vy: fc.double({ min: -200, max: 200, noNaN: true }),
          exponent: fc.double({ min: -9, max: -2, noNaN: true }),
          over: fc.boolean(),
          // the same flight along y, or the other way
          swap: fc.boolean(),
          mirror: fc.constantFrom(-1, 1),
        }),
        ({ x, y, vy, exponent, over, swap, mirror }) => {
          const seconds = 0.6;
          const excess = (over ? 1 : -1) * 10 ** exponent;
          // the start whose greatest velocity is the limit and the excess
          let vx = 990;
          for (let i = 0, off = 1; i < 8 && Math.abs(off) > 1e-13 * LIMIT; i++) {
            off = LIMIT + excess - fly([x, y, vx, vy], seconds, false).fastest;
            vx += off;
          }
          const truth = fly([x, y, vx, vy], seconds, true);
          expect(truth.reached >= 0).toBe(over);
          counts[over ? 'held' : 'free']++;

          const turn = (a: number, b: number) => (swap ? { x: b, y: mirror * a } : { x: mirror * a, y: b });
          const [place, velocity] = [turn(x, y), turn(vx, vy)];
          const level = plainLevel({
            astronaut: { ...place, vx: velocity.x, vy: velocity.y },
            range: RANGE,
            asteroids: [{ x: 0, y: 0, radius: 16 }],
          });
          const run = simulate(compile(level), [[0, 60]], { maxTime: seconds });
          const state = new Float64Array(STATE_SIZE);
          run.trajectory.at(seconds, state);
          const along = swap ? mirror * state[1] : mirror * state[0];
          const across = swap ? state[0] : state[1];
          const speed = swap ? mirror * state[3] : mirror * state[2];
          expect(Math.abs(speed - truth.end[2])).toBeLessThan(3e-10);
          expect(Math.abs(along - truth.end[0])).toBeLessThan(1e-9);
          expect(Math.abs(across - truth.end[1])).toBeLessThan(1e-9);
          for (let i = 0; i <= 600; i++) {
            run.trajectory.at(i / 1000, state);
            expect(Math.max(Math.abs(state[2]), Math.abs(state[3]))).toBeLessThanOrEqual(LIMIT);
          }
        },
      ),
      { numRuns: 12 },
    );
    expectDeep(Math.min(counts.held, counts.free)).toBeGreaterThan(3);
  });
});

describe('the speed limit on a line through a field', () => {
  it('lets her pass the target without moving it, or the field', () => {
    fc.assert(
      fc.property(
        fc.record({
          accuracy: fc.constantFrom('precise', 'standard', 'fast'),
          recoil: fc.boolean(),
          // where the field begins behind her, and the asteroid ahead
          behind: fc.double({ min: 20, max: 500, noNaN: true }),
          ahead: fc.double({ min: 50, max: 400, noNaN: true }),
          vertical: fc.boolean(),
          mirror: fc.constantFrom(-1, 1),
        }),
        ({ accuracy, recoil, behind, ahead, vertical, mirror }) => {
          const at = (along: number) => (vertical ? { x: 0, y: mirror * along } : { x: mirror * along, y: 0 });
          const end = 700;
          const level = plainLevel({
            recoil,
            range: 5000,
            astronaut: vertical ? { vy: mirror * LIMIT } : { vx: mirror * LIMIT },
            repulsors: [{ ...at(-behind), radius: behind + end }],
            asteroids: [{ ...at(ahead), radius: 16 }],
            minerals: [{ x: 3000, y: 3000, radius: 4 }],
          });
          const run = simulate(compile(level, accuracy), [[0, 60]], { maxTime: 0.8 });
          // inside the field the push holds her at the limit; nothing happens but that she leaves it
          expect(run.events.filter(({ type }) => type !== 'press' && type !== 'target').map(({ type }) => type)).toEqual([
            'leave',
          ]);
          expect(Math.abs((run.events.at(-1)?.time ?? 0) - end / LIMIT)).toBeLessThan(1e-9);
          const rock = new Float64Array(2);
          run.trajectory.asteroidsAt(0.7, rock);
          // dragged to her and back by no more than 1 / 32 px/s2
          expect(Math.hypot(rock[0] - at(ahead).x, rock[1] - at(ahead).y)).toBeLessThan(recoil ? 0.02 : 1e-12);
        },
      ),
      { numRuns: 25 },
    );
  });
});

describe.each(continuousNames)('once released, the limit does not hold her again without a force: %s', (accuracy) => {
  it('in a bounded number of pieces', () => {
    const even = (min: number, max: number) => fc.integer({ min: 0, max: 1000 }).map((k) => min + ((max - min) * k) / 1000);
    fc.assert(
      fc.property(even(-600, 600), even(-600, 600), fc.constantFrom(-1000, 1000), even(-1000, 1000), (x, y, vx, vy) => {
        const level = plainLevel({ astronaut: { x: 0, y: 0, vx, vy }, range: 1000, asteroids: [{ x, y, radius: 16 }] });
        const budget = new WorkBudget(2000);
        expect(simulate(compile(level, accuracy), [[0, 120]], { maxTime: 2, budget }).stopped).toBeNull();
      }),
    );
  });

  it('passing an asteroid on the axis that is held', () => {
    const asteroids = [{ x: -250, y: -300, radius: 16 }];
    const level = plainLevel({ astronaut: { x: 0, y: 0, vx: -1000, vy: -1000 }, range: 1000, asteroids });
    const budget = new WorkBudget(2000);
    const run = simulate(compile(level, accuracy), [[0, 60]], { maxTime: 1, budget });
    expect(run.stopped).toBeNull();
    expect(run.final.vx).toBeGreaterThan(-1000);
  });
});

/** From rest along x, pulled by an asteroid at x, y that she draws near, at most 10 px/s along an axis. Same for every accuracy. */
const atLimitBySmallSteps = once((x: number, y: number, vy: number, recoil: number, seconds: number) => {
  const [hers, rock] = [
    [0, 0, 0, vy],
    [x, y, 0, 0],
  ];
  let held = 0;
  const limited = (v: number) => Math.min(10, Math.max(-10, v));
  const h = 2e-5;
  for (let n = 0; n < seconds / h; n++) {
    const [dx, dy] = [rock[0] - hers[0], rock[1] - hers[1]];
    const d = Math.sqrt(dx * dx + dy * dy);
    const pull = (39 * (1 - d / 1000)) / d;
    const back = recoil / 32 / d;
    hers[2] = limited(hers[2] + pull * dx * h);
    hers[3] = limited(hers[3] + pull * dy * h);
    rock[2] -= back * dx * h;
    rock[3] -= back * dy * h;
    for (const body of [hers, rock]) {
      body[0] += body[2] * h;
      body[1] += body[3] * h;
    }
    if (Math.abs(hers[2]) === 10) held++;
  }
  return { hers, held };
});

describe.each(continuousNames)('at the limit while recoil moves the asteroid: %s', (accuracy) => {
  it('she moves at the limit, as in small steps of another program', () => {
    const even = (min: number, max: number) => fc.integer({ min: 0, max: 1000 }).map((k) => min + ((max - min) * k) / 1000);
    let held = 0;
    fc.assert(
      fc.property(even(20, 60), even(-40, 40), even(-8, 8), even(1, 400), (x, y, vy, recoil) => {
        const rules = { speedLimit: 10, recoil };
        const level = {
          ...plainLevel({ astronaut: { x: 0, y: 0, vx: 0, vy }, asteroids: [{ x, y, radius: 16 }], range: 1000, recoil: true }),
          rules,
        };
        const seconds = 1.5;
        const truth = atLimitBySmallSteps(x, y, vy, recoil, seconds);
        held += truth.held;
        const { final } = simulate(compile(level, accuracy), [[0, 200]], { maxTime: seconds });
        const [hx, hy, hvx, hvy] = truth.hers;
        expect(Math.hypot(final.x - hx, final.y - hy)).toBeLessThan(0.05);
        expect(Math.hypot(final.vx - hvx, final.vy - hvy)).toBeLessThan(0.05);
      }),
      { numRuns: 12 },
    );
    expectDeep(held).toBeGreaterThan(400);
  });
});

describe('the speed limit in a wind, with recoil', () => {
  it('releases her when her own acceleration turns, as in another program', () => {
    const even = (min: number, max: number) => fc.integer({ min: 0, max: 1e6 }).map((k) => min + ((max - min) * k) / 1e6);
    let compared = 0;
    fc.assert(
      fc.property(
        fc.record({
          speedLimit: even(15, 60),
          x: even(-150, 150),
          y: even(60, 150),
          vx: even(-1, 1),
          vy: even(-1, 1),
          ax: even(-35, 35),
          ay: even(-35, 35),
          recoil: fc.boolean(),
          strength: even(1, 600),
        }),
        ({ speedLimit, x, y, vx, vy, ax, ay, recoil, strength }) => {
          const seconds = 3;
          const from = (dx: number, dy: number): Level => ({
            ...plainLevel({
              astronaut: { x: dx, y: dy, vx: speedLimit * vx, vy: speedLimit * vy },
              asteroids: [{ x, y, radius: 16 }],
              range: 2000,
              recoil,
            }),
            winds: [{ id: null, x: 0, y: 0, radius: 4000, ax, ay }],
            rules: { speedLimit, recoil: strength },
          });
          const level = from(0, 0);
          const truth = limitedFlight(level, seconds);
          // by how much an error grows until the end, from differences
          const shift = 1e-6;
          const grows = [from(shift, 0), from(0, shift)].map((moved) => {
            const there = limitedFlight(moved, seconds);
            return Math.hypot(there.x - truth.x, there.y - truth.y) / shift;
          });
          const sensitivity = Math.max(1, ...grows);
          if (sensitivity > 100) return;
          compared++;
          const { final } = simulate(compile(level), [[0, 60 * seconds]], { maxTime: seconds });
          expect(Math.hypot(final.x - truth.x, final.y - truth.y)).toBeLessThan(1e-9 * sensitivity);
        },
      ),
      { numRuns: 25 },
    );
    expectDeep(compared).toBeGreaterThan(15);
  });
});
