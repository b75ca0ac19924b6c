import { describe, expect, it } from 'vitest';
import { ACCURACIES, type Accuracy, accuracyOf, compile, createSimulation } from '../../engine/index.ts';
import {
  cheapestGoodEnough,
  METHODS,
  type Measured,
  measureCosts,
  measureWorkPrecision,
  pathOf,
  quantile,
  RATES,
  referenceOf,
  TOLERANCES,
} from '../../engine/work-precision/index.ts';
import type { Level } from '../../schema/index.ts';
import { plainLevel } from '../engine/plain-level.ts';
import { compareWith } from '../judges/compare-with.ts';
import { missedContacts } from '../judges/tunnelling.ts';
import { SWING } from './scenes.ts';

const TICKS = 600;
/** What rounding to doubles leaves on this swing, px. */
const ROUNDING = 1e-11;
const HOLDS = [[0, 600]] as const;
const reference = referenceOf(SWING, HOLDS, TICKS);

type FixedSteps = 'euler' | 'verlet' | 'rk4';

const fixed = (integrator: FixedSteps, rate: number, level = SWING, truth = reference) =>
  compareWith(truth, level, HOLDS, accuracyOf({ integrator, rate, tolerance: null, contact: 'swept' }), TICKS).error;

/** The same swing about a light asteroid, which follows her; and from within a field, which hides the pull but not the recoil. */
const LIGHT: Level = { ...SWING, recoil: true, asteroids: [{ ...SWING.asteroids[0], radius: 0.5 }] };
const DRAGGED: Level = { ...LIGHT, repulsors: [{ id: null, x: 2000, y: 0, radius: 5000 }], range: 5000 };

/** Where the asteroid is at the end. */
function rockAt(level: Level, accuracy: Accuracy): [x: number, y: number] {
  const simulation = createSimulation(compile(level, accuracy));
  simulation.advance(TICKS, true);
  const at = new Float64Array(2);
  simulation.readAsteroids(at);
  return [at[0], at[1]];
}

/** Slope of log error over log step by least squares. */
function order(rates: readonly number[], errors: readonly number[]): number {
  const x = rates.map((rate) => -Math.log2(rate));
  const y = errors.map((error) => Math.log2(error));
  const mean = (list: number[]) => list.reduce((a, b) => a + b, 0) / list.length;
  const [mx, my] = [mean(x), mean(y)];
  return x.reduce((sum, xi, i) => sum + (xi - mx) * (y[i] - my), 0) / x.reduce((sum, xi) => sum + (xi - mx) ** 2, 0);
}

describe('errors on a smooth swing', () => {
  // an integrator with a slip in a coefficient still draws a nice curve, but of a lower order
  it.each([
    ['euler', 1],
    ['verlet', 2],
    ['rk4', 4],
  ] as const)('of %s fall with the power %i of the step', (integrator, expected) => {
    const rates = RATES.slice(2, 6);
    const errors = rates.map((rate) => fixed(integrator, rate));
    expect(order(rates, errors)).toBeGreaterThan(expected - 0.15);
    expect(order(rates, errors)).toBeLessThan(expected + 0.15);
  });

  it.each([
    ['euler', 1],
    ['verlet', 2],
    ['rk4', 4],
  ] as const)(
    'of %s do so with recoil, too, and those of an asteroid that is dragged from within a field',
    (integrator, expected) => {
      const rates = RATES.slice(2, 6);
      const truth = referenceOf(LIGHT, HOLDS, TICKS);
      expect(truth.doubt).toBeNull();
      const errors = rates.map((rate) => fixed(integrator, rate, LIGHT, truth));
      expect(order(rates, errors)).toBeGreaterThan(expected - 0.15);
      // at higher rates only rounding is left of the error of rk4
      const slow = RATES.slice(0, 3);
      const [x, y] = rockAt(DRAGGED, ACCURACIES.precise);
      const beside = slow.map((rate) => {
        const [at, up] = rockAt(DRAGGED, accuracyOf({ integrator, rate, tolerance: null, contact: 'swept' }));
        return Math.hypot(at - x, up - y);
      });
      expect(order(slow, beside)).toBeGreaterThan(expected - 0.15);
    },
  );

  it('of taylor stay below the tolerance times the seconds, down to what rounding leaves', () => {
    for (const tolerance of TOLERANCES) {
      const accuracy = accuracyOf({ integrator: 'taylor', rate: null, tolerance, contact: 'swept' });
      const { error } = compareWith(reference, SWING, HOLDS, accuracy, TICKS);
      expect(error).toBeLessThan(Math.max((tolerance * TICKS) / 60, ROUNDING));
    }
  });
});

describe('the reference', () => {
  it('is confirmed by a second one of another method, far below anything that is measured', () => {
    expect(reference.doubt).toBeNull();
    expect(reference.method).toMatch(/Gauss/);
    expect(reference.knownTo).toBeGreaterThan(0);
    expect(reference.knownTo).toBeLessThan(1e-22);
  });

  it('that no second one confirms says so, and is not exactly known', () => {
    const stuck = plainLevel({
      range: 400,
      asteroids: [{ x: 0, y: 0, radius: 16 }],
      repulsors: [{ x: 20, y: 0, radius: 30 }],
    });
    const known = referenceOf(stuck, [[0, 60]], 60);
    expect(known).toMatchObject({ knownTo: null, outcome: 'timeout' });
    expect(known.method).toMatch(/^the engine itself/);
    expect(known.doubt).toMatch(/^no reference covers this run: rests in the target/);
  });

  it('is what another method comes to', () => {
    expect(fixed('rk4', 3840)).toBeLessThan(1e-10);
  });
});

describe('methods', () => {
  it('have names of their own, the named accuracies among them', () => {
    const names = METHODS.map(({ name }) => name);
    expect(new Set(names).size).toBe(names.length);
    expect(names).toEqual(expect.arrayContaining(Object.keys(ACCURACIES)));
    for (const method of METHODS) if (method.name in ACCURACIES) expect(method).toEqual(ACCURACIES[method.name as 'fast']);
  });
});

describe('paths', () => {
  it('hold the states at ticks before the end, the same as advancing in one go', () => {
    const level: Level = { ...SWING, blackHole: { x: 60, y: 90, radius: 18 } };
    const simulation = createSimulation(compile(level, 'precise'));
    const path = pathOf(simulation, HOLDS, TICKS);
    expect(path.ending?.outcome).toBe('completed');
    const end = path.ending?.time ?? 0;
    expect((path.count - 1) / 60).toBeLessThan(end);
    expect(path.count / 60).toBeGreaterThanOrEqual(end);
    const state = new Float64Array(6);
    simulation.reset();
    simulation.advance(path.count - 1, true);
    simulation.readState(state);
    expect([path.x[path.count - 1], path.y[path.count - 1]]).toEqual([state[0], state[1]]);
  });

  it('of another outcome are told from the reference', () => {
    const simulated = compareWith(reference, { ...SWING, range: 105 }, HOLDS, ACCURACIES.precise, TICKS);
    expect(simulated).toMatchObject({ outcome: 'lost', sameVerdict: false });
    expect(reference.outcome).toBe('timeout');
  });
});

describe('costs', () => {
  /** A clock that each reading moves. */
  const ticking = () => {
    let readings = 0;
    return () => readings++;
  };

  /** A clock that only the work moves, ms. */
  function fakeWork() {
    let clock = 0;
    const player = (ms: number, seconds: number) => ({
      code: 'fake',
      play() {
        clock += ms;
        return seconds;
      },
    });
    return { now: () => clock, player };
  }

  it('are microseconds per simulated second, of each player', () => {
    const { now, player } = fakeWork();
    const costs = measureCosts([player(2, 10), player(0.5, 1)], now, { budget: 100, most: 100, sample: 1 });
    expect(costs[0]?.minimum).toBeCloseTo(200, 6);
    expect(costs[1]?.high).toBeCloseTo(500, 6);
  });

  it('leave out what a player prepares', () => {
    let clock = 0;
    const player = {
      code: 'fake',
      prepare() {
        clock += 100;
      },
      play() {
        clock += 3;
        return 3;
      },
    };
    expect(measureCosts([player], () => clock, { budget: 50, most: 50, sample: 1 })[0]?.minimum).toBeCloseTo(1000, 6);
  });

  it('of code that gets faster as it runs are those of warm code, whoever comes first', () => {
    let clock = 0;
    const slowStart = (code: string) => {
      let plays = 0;
      return {
        code,
        play() {
          plays++;
          clock += plays < 400 ? 0.4 : 0.02;
          return 1;
        },
      };
    };
    const costs = measureCosts([slowStart('one'), slowStart('two')], () => clock, { budget: 2000, most: 1e4, sample: 1 });
    for (const cost of costs) {
      expect(cost?.minimum).toBeCloseTo(20, 6);
      expect(cost?.high).toBeCloseTo(20, 6);
    }
  });

  it('end when the time is used up: who had fewer turns says so, and who had none has no cost', () => {
    const { now, player } = fakeWork();
    const heavy = Array.from({ length: 10 }, () => player(100, 2));
    const turns = (budget: number) =>
      measureCosts(heavy, now, { budget, most: budget, sample: 1 }).map((cost) => cost?.rounds ?? 0);
    expect(turns(1e5)).toEqual(heavy.map(() => 41));
    expect(turns(450)).toEqual([1, 1, 1, 1, 1, 0, 0, 0, 0, 0]);
    expect(now()).toBeGreaterThan(1e4);
    const before = now();
    const some = turns(4000);
    expect(now() - before).toBeLessThanOrEqual(4100);
    expect(some).toEqual([1, 2, 1, 1, 1, 1, 1, 1, 1, 1]);
    const [, , , , fifth] = measureCosts(heavy, now, { budget: 450, most: 450, sample: 1 });
    expect(fifth).toEqual({ minimum: 5e4, high: 5e4, rounds: 1 });
  });

  it('of a run that leaves no time are those of the named settings first, then of the coarsest; the others are named', () => {
    const now = ticking();
    const measure = (comparing: number, timing: number) =>
      measureWorkPrecision(SWING, HOLDS, {
        maxTime: 1,
        maxWork: 400_000,
        now,
        budget: { comparing, timing, most: timing },
        methods: METHODS,
      });
    const named = (list: readonly { readonly accuracy: Accuracy }[]) => list.map(({ accuracy }) => accuracy.name);
    const few = measure(5, 1e6);
    expect(named(few.methods)).toEqual(['arcade', 'fast', 'standard', 'taylor 1e-2 px', 'precise']);
    expect([...named(few.methods), ...named(few.unmeasured)].sort()).toEqual(
      named(METHODS.map((accuracy) => ({ accuracy }))).sort(),
    );
    expect(few.unmeasured.every(({ why, time }) => why === 'time' && time === 0)).toBe(true);
    const untimed = measure(1e6, 1);
    expect(named(untimed.methods)).toEqual(['arcade']);
    expect(untimed.unmeasured).toHaveLength(METHODS.length - 1);
    expect(untimed.unmeasured.every(({ why, time }) => why === 'time' && time === 1)).toBe(true);
  });

  it('are not measured of a setting that takes more work than is allowed, and until when it played is said', () => {
    const { methods, unmeasured } = measureWorkPrecision(SWING, HOLDS, {
      maxTime: 10,
      maxWork: 100,
      now: ticking(),
      budget: { comparing: 100, timing: 1000, most: 1000 },
      methods: [ACCURACIES.precise, ACCURACIES.standard],
    });
    expect(methods.map(({ accuracy }) => accuracy.name)).toEqual(['precise']);
    expect(unmeasured).toHaveLength(1);
    expect(unmeasured[0]).toMatchObject({ accuracy: { name: 'standard' }, why: 'work' });
    expect(unmeasured[0].time).toBeGreaterThan(0.2);
    expect(unmeasured[0].time).toBeLessThan(10);
  });

  it('and errors make a diagram, of which the cheapest good setting is chosen', () => {
    let clock = 0;
    const now = () => {
      clock += 0.01;
      return clock;
    };
    const methods = [ACCURACIES.arcade, ACCURACIES.fast, ACCURACIES.precise];
    const budget = { comparing: 1, timing: 1, most: 9 };
    const { methods: measured } = measureWorkPrecision(SWING, HOLDS, { maxTime: 1, maxWork: 400_000, now, budget, methods });
    expect(measured.map(({ accuracy }) => accuracy)).toEqual(methods);
    const make = (error: number, minimum: number, sameVerdict = true): Measured => ({
      ...measured[0],
      error,
      sameVerdict,
      cost: { minimum, high: minimum, rounds: 5 },
    });
    const best = make(1e-3, 5);
    expect(cheapestGoodEnough([make(0.1, 1), make(1e-9, 9), best, make(1e-9, 2, false)])).toBe(best);
    expect(cheapestGoodEnough([make(0.1, 1)])).toBeNull();
  });
});

describe('missed contacts', () => {
  const lcg = () => {
    let state = 12345;
    return () => {
      state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
      return state / 2 ** 32;
    };
  };
  const missed = (radius: number, speed: number, rate = 60) =>
    missedContacts(radius, speed, { rate, flights: 400, random: lcg() });

  it('are none where frames are very many', () => {
    expect(missed(4, 1000, 60_000).frame).toBe(0);
  });

  it('grow with speed and shrink with radius and rate; the swept test misses none', () => {
    expect(missed(0.5, 1000).frame).toBeGreaterThan(missed(0.5, 300).frame);
    expect(missed(0.5, 1000).frame).toBeGreaterThan(missed(16, 1000).frame);
    expect(missed(0.5, 1000).frame).toBeGreaterThan(missed(0.5, 1000, 240).frame);
    for (const radius of [0.5, 4, 16]) for (const speed of [50, 400, 1000]) expect(missed(radius, speed).swept).toBe(0);
  });
});

it('quantiles lie between the values', () => {
  expect(quantile([3, 1, 2], 0.5)).toBe(2);
  expect(quantile([0, 10], 0.9)).toBe(9);
  expect(quantile([4], 1)).toBe(4);
  expect(() => quantile([], 0.5)).toThrow(RangeError);
});
