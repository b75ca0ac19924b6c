import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { drawSet, type Fleet, type Policy, type ShardCosts, simulateFleet, splitSet } from '../../bench/fleet/index.ts';
import { addToLeast } from '../../cli/fleet/index.ts';
import { seeded } from '../scenes/seeded.ts';

const HOUR = 3600;

const NO_FAILURES: Omit<Fleet, 'machines' | 'cores'> = {
  taskDeathsPerHour: 0,
  machineDeathsPerHour: 0,
  detection: 0,
  restartDelay: 0,
  repair: 0,
  stragglers: 0,
  slowdown: 1,
};

const fleetOf = (machines: number, cores: number, failures: Partial<Fleet> = {}): Fleet => ({
  ...NO_FAILURES,
  machines,
  cores,
  ...failures,
});

const shardsOf = (useful: readonly number[], overhead = 0): ShardCosts => ({
  useful: Float64Array.from(useful),
  overhead: new Float64Array(useful.length).fill(overhead),
});

const AT_ONCE: Policy = { rerun: 'at once', patience: null };
const AFTER_THE_ROUND: Policy = { rerun: 'after the round', patience: null };

const sum = (values: Iterable<number>): number => [...values].reduce((total, value) => total + value, 0);

const costList = (maxLength: number) => fc.array(fc.double({ min: 0.1, max: 1000, noNaN: true }), { minLength: 1, maxLength });
const count = (max: number) => fc.integer({ min: 1, max });

/** The least makespan of all ways to spread jobs over slots. */
function optimum(jobs: readonly number[], slots: number): number {
  const loads = new Array<number>(slots).fill(0);
  const place = (job: number): number => {
    if (job === jobs.length) return Math.max(...loads);
    let best = Number.POSITIVE_INFINITY;
    for (let slot = 0; slot < slots; slot++) {
      loads[slot] += jobs[job];
      best = Math.min(best, place(job + 1));
      loads[slot] -= jobs[job];
      // slots without load are alike
      if (loads[slot] === 0) break;
    }
    return best;
  };
  return place(0);
}

describe('without failures', () => {
  it('equal shards take ceil(shards / slots) times the cost of one', () => {
    fc.assert(
      fc.property(count(200), count(6), count(4), fc.integer({ min: 1, max: 50 }), (shards, machines, cores, cost) => {
        const { makespan, lost, attempts } = simulateFleet(
          shardsOf(new Array(shards).fill(cost), 2),
          fleetOf(machines, cores),
          AT_ONCE,
          seeded(1),
        );
        expect(makespan).toBe(Math.ceil(shards / (machines * cores)) * (cost + 2));
        expect([lost, attempts]).toEqual([0, shards]);
      }),
    );
  });

  it('one slot takes the sum', () => {
    fc.assert(
      fc.property(costList(60), (costs) => {
        const { makespan, useful, overhead } = simulateFleet(shardsOf(costs, 3), fleetOf(1, 1), AT_ONCE, seeded(1));
        expect(makespan).toBeCloseTo(sum(costs) + 3 * costs.length, 6);
        expect(useful).toBeCloseTo(sum(costs), 6);
        expect(overhead).toBeCloseTo(3 * costs.length, 6);
      }),
    );
  });

  it("shards as they come are within 2 - 1/slots of the optimum, levels by the plan's balance within 4/3 - 1/(3 slots)", () => {
    fc.assert(
      fc.property(costList(7), fc.integer({ min: 2, max: 4 }), (costs, slots) => {
        const best = optimum(costs, slots);
        const asTheyCome = simulateFleet(shardsOf(costs), fleetOf(1, slots), AT_ONCE, seeded(1)).makespan;
        expect(asTheyCome).toBeGreaterThanOrEqual(best - 1e-9);
        expect(asTheyCome).toBeLessThanOrEqual((2 - 1 / slots) * best + 1e-9);
        const loads = new Float64Array(slots);
        addToLeast(
          costs.toSorted((a, b) => b - a),
          loads,
        );
        const balanced = simulateFleet(shardsOf([...loads]), fleetOf(1, slots), AT_ONCE, seeded(1)).makespan;
        expect(balanced).toBeGreaterThanOrEqual(best - 1e-9);
        expect(balanced).toBeLessThanOrEqual((4 / 3 - 1 / (3 * slots)) * best + 1e-9);
      }),
    );
  });
});

describe('with failures', () => {
  // a shard of T hours that starts anew whenever it dies, and waits d hours before: (e^(rate T) - 1) (1 / rate + d)
  const SAMPLES = 20_000;
  const rate = 0.7;
  const T = 1.5;
  const meanOf = (fleet: Partial<Fleet>, policy: Policy): number => {
    const random = seeded(20_240_601);
    const one = shardsOf([T * HOUR]);
    return (
      sum(Array.from({ length: SAMPLES }, () => simulateFleet(one, fleetOf(1, 1, fleet), policy, random).makespan)) /
      SAMPLES /
      HOUR
    );
  };
  const grown = Math.exp(rate * T);
  const expected = (grown - 1) / rate;
  const standardError = Math.sqrt(grown ** 2 - 2 * rate * T * grown - 1) / rate / Math.sqrt(SAMPLES);

  it.each([
    ['a task that dies', { taskDeathsPerHour: rate }],
    ['a machine that dies', { machineDeathsPerHour: rate }],
    ['both', { taskDeathsPerHour: rate / 4, machineDeathsPerHour: (3 * rate) / 4 }],
  ])('%s: a shard takes (e^(rate T) - 1) / rate in the mean', (_, failures) => {
    for (const policy of [AT_ONCE, AFTER_THE_ROUND]) {
      expect(Math.abs(meanOf(failures, policy) - expected)).toBeLessThan(4 * standardError);
    }
  });

  it('each death costs the time until it is noticed, and the delay', () => {
    const delays = { detection: 0.2 * HOUR, restartDelay: 0.3 * HOUR };
    const deaths = (grown - 1) * 0.5;
    const error = 4 * (standardError + (0.5 * Math.sqrt(grown * (grown - 1))) / Math.sqrt(SAMPLES));
    expect(Math.abs(meanOf({ taskDeathsPerHour: rate, ...delays }, AT_ONCE) - expected - deaths)).toBeLessThan(error);
  });

  it('a machine that is down takes nothing: its shard waits until it is back', () => {
    const deaths = (grown - 1) * 0.4;
    const error = 4 * (standardError + (0.4 * Math.sqrt(grown * (grown - 1))) / Math.sqrt(SAMPLES));
    const back = { detection: 0.1 * HOUR, restartDelay: 0.1 * HOUR, repair: 0.4 * HOUR };
    expect(Math.abs(meanOf({ machineDeathsPerHour: rate, ...back }, AT_ONCE) - expected - deaths)).toBeLessThan(error);
  });

  it('counts every shard once, and slots are taken by what counts and what is lost', () => {
    const fleets = fc.record({
      machines: count(5),
      cores: count(4),
      taskDeathsPerHour: fc.constantFrom(0, 1, 20),
      machineDeathsPerHour: fc.constantFrom(0, 0.5, 10),
      detection: fc.constantFrom(0, 30, 900),
      restartDelay: fc.constantFrom(0, 60),
      repair: fc.constantFrom(0, 120, 3600),
      stragglers: fc.constantFrom(0, 0.1, 1),
      slowdown: fc.constantFrom(1, 4),
    });
    const policies = fc.record({
      rerun: fc.constantFrom('at once' as const, 'after the round' as const),
      patience: fc.constantFrom(null, 0.5, 1.5, 3),
    });
    const costs = fc.array(fc.double({ min: 1, max: 300, noNaN: true }), { minLength: 1, maxLength: 80 });
    fc.assert(
      fc.property(costs, fleets, policies, fc.integer(), (useful, fleet, policy, seed) => {
        const shards = shardsOf(useful, 1);
        const outcome = simulateFleet(shards, fleet, policy, seeded(seed));
        expect([...outcome.counted]).toEqual(useful.map(() => 1));
        expect(outcome.useful).toBeCloseTo(sum(useful), 6);
        expect(outcome.overhead).toBeCloseTo(useful.length, 6);
        const { taken, slow, lost, makespan, attempts } = outcome;
        expect(Math.abs(taken - (outcome.useful + outcome.overhead + slow + lost))).toBeLessThan(1e-9 * taken + 1e-6);
        expect(taken).toBeLessThanOrEqual(fleet.machines * fleet.cores * makespan * (1 + 1e-9));
        expect(makespan).toBeGreaterThanOrEqual(Math.max(...useful) + 1);
        expect(attempts).toBeGreaterThanOrEqual(useful.length);
        if (attempts === useful.length) expect(lost).toBe(0);
        expect(simulateFleet(shards, fleet, policy, seeded(seed))).toEqual(outcome);
      }),
    );
  });
});

describe('a task that runs slowly', () => {
  /** Numbers in this order, then only `last`. */
  const scripted = (numbers: readonly number[], last: number) => {
    const left = [...numbers];
    return () => left.shift() ?? last;
  };
  const fleet = fleetOf(1, 2, { stragglers: 0.5, slowdown: 10 });

  it('keeps all waiting without a copy', () => {
    const { makespan, slow, lost } = simulateFleet(shardsOf([10, 10, 10]), fleet, AT_ONCE, scripted([0], 0.9));
    expect([makespan, slow, lost]).toEqual([100, 90, 0]);
  });

  it('gets a copy once nothing waits and it has taken longer than the others, and the first one counts', () => {
    // the others end at 10 and 20; the copy starts at 2.5 times their mean
    const { makespan, slow, lost, attempts } = simulateFleet(
      shardsOf([10, 10, 10]),
      fleet,
      { rerun: 'at once', patience: 2.5 },
      scripted([0], 0.9),
    );
    expect([makespan, slow, lost, attempts]).toEqual([35, 0, 35, 4]);
  });

  it('gets one copy only, however many cores are free', () => {
    // at 11, the first and the last get a copy; the last ends at 12, and two cores are free
    const outcome = simulateFleet(
      shardsOf([10, 10, 12]),
      fleetOf(1, 4, { stragglers: 0.5, slowdown: 10 }),
      { rerun: 'at once', patience: 1.1 },
      scripted([0], 0.9),
    );
    expect(outcome).toMatchObject({ makespan: 21, lost: 22, attempts: 5 });
  });

  it('counts itself where its copy is even slower', () => {
    const outcome = simulateFleet(
      shardsOf([10, 10]),
      fleet,
      { rerun: 'at once', patience: 9.5 },
      // the first is slow, the second is not, the copy is
      scripted([0, 0.9, 0], 0.9),
    );
    expect(outcome).toMatchObject({ makespan: 100, slow: 90, lost: 5, attempts: 3 });
  });

  it('gets its copy before its death is noticed', () => {
    const dying = fleetOf(1, 2, { taskDeathsPerHour: 360, detection: 1000 });
    // the first dies after 10 ln 2 s; 1 - e^-10: nobody else does
    const outcome = simulateFleet(
      shardsOf([10, 10]),
      dying,
      { rerun: 'at once', patience: 2 },
      scripted([0.5], 1 - Math.exp(-10)),
    );
    expect(outcome).toMatchObject({ makespan: 30, lost: 30, attempts: 3 });
  });
});

describe('after the round', () => {
  it('what died waits until all others have ended', () => {
    const fleet = fleetOf(1, 2, { taskDeathsPerHour: 360, restartDelay: 5 });
    const script = () => {
      const numbers = [0.5];
      return () => numbers.shift() ?? 1 - Math.exp(-10);
    };
    const costs = shardsOf([10, 10, 10]);
    const firstDeath = 10 * Math.log(2);
    expect(simulateFleet(costs, fleet, AFTER_THE_ROUND, script()).makespan).toBeCloseTo(firstDeath + 10 + 5 + 10, 9);
    // the free core takes the third shard at the first death, the other the first shard once it waits
    expect(simulateFleet(costs, fleet, AT_ONCE, script()).makespan).toBeCloseTo(firstDeath + 5 + 10, 9);
  });
});

describe('a drawn set', () => {
  const COSTS = [90, 8, 2, 1];

  it('has the levels of the rule in its shards, whatever their number, and reads the others', () => {
    const set = drawSet(5000, COSTS, seeded(7));
    for (const shards of [1, 7, 300]) {
      const { useful, overhead } = splitSet(set, shards, 'rule', { start: 2, scan: 0.5 });
      const own = new Array<number>(shards).fill(0);
      const total = new Array<number>(shards).fill(0);
      for (const [level, hash] of set.hashes.entries()) {
        own[hash % shards]++;
        total[hash % shards] += COSTS[set.drawn[level]];
      }
      expect([...useful]).toEqual(total);
      expect([...overhead]).toEqual(own.map((levels) => 2 + 0.5 * (5000 - levels)));
    }
  });

  it('draws all costs alike', () => {
    const { drawn } = drawSet(40_000, COSTS, seeded(3));
    for (const cost of COSTS.keys()) {
      const share = drawn.filter((one) => one === cost).length / 40_000;
      // 5 standard deviations
      expect(Math.abs(share - 0.25)).toBeLessThan(5 * Math.sqrt((0.25 * 0.75) / 40_000));
    }
    expect(() => drawSet(10, [], seeded(1))).toThrow(/expected 1 to 65536 costs, found 0/);
  });

  it('is balanced by costs: nothing is lost, and the slowest shard is at most one cheapest level above the others', () => {
    const set = drawSet(5000, COSTS, seeded(7));
    const byRule = splitSet(set, 20, 'rule', { start: 0, scan: 1 });
    const balanced = splitSet(set, 20, '--costs', { start: 0, scan: 1 });
    expect(sum(balanced.useful)).toBe(sum(byRule.useful));
    expect(sum(balanced.overhead)).toBe(sum(byRule.overhead));
    expect(Math.max(...balanced.useful) - Math.min(...balanced.useful)).toBeLessThanOrEqual(1);
    expect(Math.max(...byRule.useful) - Math.min(...byRule.useful)).toBeGreaterThan(100);
  });

  it('leaves all beyond the most that a plan assigns to the rule: the cheapest', () => {
    const set = drawSet(150_000, [50, 1], seeded(5));
    const dear = set.drawn.filter((cost) => cost === 0).length;
    expect(dear).toBeGreaterThan(65_536);
    const byRule = splitSet(set, 10, 'rule', { start: 0, scan: 0 });
    const balanced = splitSet(set, 10, '--costs', { start: 0, scan: 0 });
    expect(sum(balanced.useful)).toBe(sum(byRule.useful));
    expect(Math.max(...balanced.useful) - Math.min(...balanced.useful)).toBeLessThanOrEqual(50);
  });
});
