import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Attempt, collectStatistics, compareWithModel } from '../../check/plays/index.ts';
import { decreasing, explainingNoise } from '../../check/plays/model.ts';
import { chooseReference } from '../../check/plays/routes.ts';
import { ACCURACIES, compile, DEFAULT_TERMS } from '../../engine/index.ts';
import { createRandom, successProbability } from '../../solver/index.ts';
import { wilsonInterval } from '../../solver/measure/robustness/index.ts';
import { isHunt, itDeep, itQuick } from '../depth.ts';
import { noisy, playedBy, shippedLevel, statisticsOf } from './played.ts';

const ANY = { minerals: 'any' } as const;
const FAST = { ...DEFAULT_TERMS, accuracy: ACCURACIES.fast };

/** What `count` players do whose timing noise is `sigma` ms, and what the model makes of it. */
function play(slug: string, sigma: number, count: number, seed: number) {
  const level = shippedLevel(slug);
  const [{ holds, name }] = level.runs;
  const record = playedBy(level, 'fast');
  const plays = noisy(holds, sigma, count, seed).map((own) => record(own));
  const statistics = statisticsOf(level, FAST, plays, { reference: { holds, name } });
  return { statistics, model: compareWithModel(compile(level, 'fast'), holds, statistics, ANY, { samples: 300 }) };
}

describe('the noise that explains the success of players', () => {
  const few: [string, number][] = [['14-run-up', 80]];
  const more = ['04-slingshot', '08-soft-landing', '13-pebbles', '16-firewalk', '22-vault'].flatMap(
    (slug): [string, number][] => [
      [slug, 120],
      [slug, 220],
    ],
  );

  it.each(isHunt ? [...few, ...more] : few)('is found for synthetic players: %s, %i ms', (slug, sigma) => {
    const { statistics, model } = play(slug, sigma, 200, sigma);
    expect(statistics.share).toBeGreaterThan(0.05);
    expect(statistics.share).toBeLessThan(0.99);
    expect(model.noise.low).toBeLessThanOrEqual(sigma);
    expect(model.noise.high).toBeGreaterThanOrEqual(sigma);
    // where success hardly changes with the noise, the interval is wide
    expect(model.noise.low).toBeGreaterThan(sigma / 2);
    expect(model.noise.high).toBeLessThan(2 * sigma);
    expect(Math.abs(model.noise.ms - sigma)).toBeLessThan(0.25 * sigma);
    // they fail where the model says
    expect(model.edges.map(({ players }) => players)).toEqual(statistics.edges.map(() => null));
  });

  itQuick('is not what explains players who miss one press only, and the comparison says which', () => {
    const level = shippedLevel('14-run-up');
    const [{ holds, name }] = level.runs;
    const record = playedBy(level, 'fast');
    const random = createRandom(5);
    const late = 1;
    const plays = Array.from({ length: 200 }, () => {
      const delay = random.below(2) === 0 ? 0 : 20 + random.below(60);
      return record(holds.map(([press, release], i) => (i === late ? [press + delay, release + delay] : [press, release])));
    });
    const statistics = statisticsOf(level, FAST, plays, { reference: { holds, name } });
    expect(statistics.share).toBeLessThan(0.9);
    const { edges } = compareWithModel(compile(level, 'fast'), holds, statistics, ANY, { samples: 300 });
    const failing = statistics.edges.flatMap(({ failed }, i) => (failed > 10 ? [i] : []));
    expect(failing.length).toBeGreaterThan(0);
    // none fails before the first press that is late
    expect(failing.every((i) => i >= 2 * late)).toBe(true);
    expect(failing.map((i) => edges[i].players)).toContain('more');
  });

  itDeep('is that of the whole curve, of which only some noises are measured', () => {
    const scene = compile(shippedLevel('14-run-up'), 'fast');
    const [{ holds }] = scene.level.runs;
    const sigmas = [10, 20, 30, 40, 50, 60, 70, 80, 100, 120, 140, 160, 180, 200, 230, 260, 300, 350, 400, 450, 500];
    const curve = sigmas.map((sigma) => successProbability(scene, holds, ANY, sigma, { samples: 300 }));
    const whole = [{ sigma: 0, p: 1, low: 1, high: 1, samples: 1 }, ...curve];
    for (const successes of [60, 90, 120]) {
      const share = { attempts: 150, successes, share: successes / 150, ...wilsonInterval(successes, 150) };
      const { noise } = compareWithModel(
        scene,
        holds,
        { ...share, edges: statisticsOf(scene.level, scene.terms, []).edges },
        ANY,
        {
          samples: 300,
        },
      );
      expect(noise).toEqual(explainingNoise(whole, share));
    }
  });

  itDeep('players fail more or less often where the intervals do not overlap', () => {
    const { statistics } = play('14-run-up', 80, 60, 80);
    const scene = compile(shippedLevel('14-run-up'), 'fast');
    const [{ holds }] = scene.level.runs;
    const said = (low: number, high: number) => {
      const edges = statistics.edges.map((edge) => ({ ...edge, low, high }));
      return compareWithModel(scene, holds, { ...statistics, edges }, ANY, { samples: 300 }).edges;
    };
    const never = said(0, 0);
    expect(never.map(({ players }) => players)).toEqual(never.map(({ low }) => (low > 0 ? 'less' : null)));
    expect(never.some(({ players }) => players === 'less')).toBe(true);
    const always = said(1, 1);
    expect(always.map(({ players }) => players)).toEqual(always.map(({ high }) => (high < 1 ? 'more' : null)));
    expect(said(0, 1).every(({ players }) => players === null)).toBe(true);
  });

  it('is 0 where the run itself takes longer than an attempt may last', () => {
    const level = shippedLevel('14-run-up');
    const [{ holds, name }] = level.runs;
    const record = playedBy(level, 'fast');
    const plays = noisy(holds, 80, 20, 1).map((own) => record(own));
    const statistics = statisticsOf(level, FAST, plays, { reference: { holds, name } });
    const { noise, edges } = compareWithModel(compile(level, 'fast'), holds, statistics, ANY, { samples: 20, maxTicks: 60 });
    expect(noise).toMatchObject({ ms: 0, high: 0 });
    expect(edges.some(({ share }) => share === 1)).toBe(true);
  });

  it('is 0 to something for players who never fail, and capped for players who fail where the model does not', () => {
    const curve = [
      { sigma: 0, p: 1, low: 1, high: 1, samples: 1 },
      { sigma: 50, p: 1, low: 0.99, high: 1, samples: 1000 },
      { sigma: 100, p: 0.6, low: 0.57, high: 0.63, samples: 1000 },
      { sigma: 500, p: 0.2, low: 0.17, high: 0.23, samples: 1000 },
    ];
    expect(explainingNoise(curve, { share: 1, low: 0.96, high: 1 })).toMatchObject({ ms: 50, low: 0, capped: false });
    expect(explainingNoise(curve, { share: 0.4, low: 0.4, high: 0.4 }).ms).toBeCloseTo(300, 9);
    expect(explainingNoise(curve, { share: 0.1, low: 0.05, high: 0.2 })).toMatchObject({ ms: 500, high: 500, capped: true });
  });

  it('a curve is made to decrease as the formula of minima and maxima says', () => {
    const means = (values: readonly number[], i: number) => {
      const mean = (a: number, b: number) => values.slice(a, b + 1).reduce((x, y) => x + y, 0) / (b - a + 1);
      const later = [...values.keys()].slice(i);
      return Math.min(...[...values.keys()].slice(0, i + 1).map((a) => Math.max(...later.map((b) => mean(a, b)))));
    };
    fc.assert(
      fc.property(fc.array(fc.integer({ min: 0, max: 20 }), { minLength: 1, maxLength: 12 }), (values) => {
        for (const [i, own] of decreasing(values).entries()) expect(own).toBeCloseTo(means(values, i), 9);
      }),
    );
  });
});

/** An attempt that failed at a place. */
const failure = (play: number, x: number, y: number, index: number): Attempt => ({
  ...{ play, x, y, tick: 100, time: 1.6, minerals: 0, edges: [], route: [], outcome: 'collided' },
  cause: { kind: 'nova', index },
});

describe('clusters', () => {
  const level = shippedLevel('07-nova-lane');

  it('are where they were planted, with all their failures', () => {
    const planted = fc.record({ count: fc.integer({ min: 8, max: 60 }), index: fc.integer({ min: 0, max: 2 }) });
    fc.assert(
      fc.property(fc.array(planted, { minLength: 1, maxLength: 5 }), fc.nat(), (groups, seed) => {
        const random = createRandom(seed);
        const failures = groups.flatMap(({ count, index }, group) =>
          Array.from({ length: count }, () => failure(0, 300 * group + 15 * random.unit(), 20 * random.unit(), index)),
        );
        // alone at their causes: too few to be a cluster
        for (let i = 0; i < 3; i++) failures.push(failure(0, 40 * i, -500, 7));
        const { clusters } = collectStatistics(
          level,
          DEFAULT_TERMS,
          failures.map((own, play) => ({ ...own, play })),
        );
        expect(clusters.map(({ count, cause }) => [count, cause.index]).sort()).toEqual(
          groups.map(({ count, index }) => [count, index]).sort(),
        );
        for (const { x, y, spread, plays, count } of clusters) {
          expect(x % 300).toBeLessThan(15);
          expect(y).toBeLessThan(20);
          expect(spread).toBeLessThan(13);
          expect(plays).toHaveLength(count);
        }
      }),
      { numRuns: 30 },
    );
  });

  it('have four failures of one cause at least, and 2 % of those of the cause', () => {
    const here = (count: number, x: number, index: number) => Array.from({ length: count }, () => failure(0, x, 0, index));
    const found = (...failures: Attempt[]) =>
      collectStatistics(
        level,
        DEFAULT_TERMS,
        failures.map((own, play) => ({ ...own, play })),
      ).clusters.map(({ count }) => count);
    expect(found(...here(3, 0, 0), ...here(3, 0, 1))).toEqual([]);
    expect(found(...here(4, 0, 0))).toEqual([4]);
    expect(found(...here(245, 0, 0), ...here(5, 500, 0))).toEqual([245, 5]);
    expect(found(...here(246, 0, 0), ...here(5, 500, 0))).toEqual([246]);
  });

  it('and causes are of one object each', () => {
    const { causes } = collectStatistics(level, DEFAULT_TERMS, [failure(0, 0, 0, 1), failure(1, 0, 0, 2), failure(2, 0, 0, 2)]);
    expect(causes).toMatchObject([
      { cause: { kind: 'nova', index: 2 }, count: 2 },
      { cause: { kind: 'nova', index: 1 }, count: 1 },
    ]);
  });

  it('have a middle and a spread', () => {
    const cross = [failure(0, 103, 50, 0), failure(1, 97, 50, 0), failure(2, 100, 53, 0), failure(3, 100, 47, 0)];
    expect(collectStatistics(level, DEFAULT_TERMS, cross).clusters).toMatchObject([{ x: 100, y: 50, spread: 3, share: 1 }]);
  });

  it('a failure more changes only the cluster that it is in, and shares', () => {
    const some = [0, 1, 2, 3, 4, 5].map((i) => failure(i, 10 * i, 0, 0));
    const other = [6, 7, 8, 9].map((i) => failure(i, 900 + i, 0, 1));
    const before = collectStatistics(level, DEFAULT_TERMS, [...some, ...other]).clusters;
    const after = collectStatistics(level, DEFAULT_TERMS, [...some, ...other, failure(10, 905, 1, 1)]).clusters;
    expect(before.map(({ count }) => count)).toEqual([6, 4]);
    expect(after.map(({ count }) => count)).toEqual([6, 5]);
    expect({ ...after[0], share: 0 }).toEqual({ ...before[0], share: 0 });
  });
});

describe('presses and releases', () => {
  it('count who comes so far and who fails there, and how far off they are', () => {
    const own = (edges: number[], succeeds: boolean, play: number): Attempt => {
      const attempt = { ...failure(play, 0, 0, 0), edges };
      return succeeds ? { ...attempt, outcome: 'completed', cause: null } : attempt;
    };
    const attempts = [own([103, 198], true, 0), own([105, 200], true, 1), own([90], false, 2), own([110, 230], false, 3)];
    const reference = { holds: [[100, 200]], name: null } as const;
    const { edges } = collectStatistics(shippedLevel('07-nova-lane'), DEFAULT_TERMS, attempts, { reference });
    expect(edges).toMatchObject([
      { type: 'start', hold: 0, tick: 0, reached: 4, failed: 0, share: 0, succeeding: null, failing: null },
      {
        ...{ type: 'press', hold: 0, tick: 100, reached: 4, failed: 1, share: 0.25 },
        succeeding: { count: 2, low: 3.5, median: 4, high: 4.5 },
        failing: { count: 2, low: -5, median: 0, high: 5 },
      },
      {
        ...{ type: 'release', hold: 0, tick: 200, reached: 3, failed: 1 },
        succeeding: { count: 2, low: -1.5, median: -1, high: -0.5 },
        failing: { count: 1, low: 30, median: 30, high: 30 },
      },
    ]);
  });
});

describe('the run that players are compared with', () => {
  const known = ['0', '1', '1'].map((route, i) => ({ name: `run ${i}`, holds: [[i, 9]] as [number, number][], route }));
  const success = (route: number[], edges: number[] = [5, 8], play = 0): Attempt => ({
    ...{ ...failure(play, 0, 0, 0), outcome: 'completed', cause: null },
    ...{ route, edges },
  });

  it('is the first run of the level on the way that most of them take who succeed', () => {
    const attempts = [
      success([0]),
      success([1]),
      success([1]),
      ...[1, 2, 3].map((i) => ({ ...failure(i, 0, 0, 0), route: [0] })),
    ];
    expect(chooseReference(known, attempts)).toEqual({ name: 'run 1', holds: [[1, 9]] });
  });

  it('is a typical success if no run takes their way, and the first run if none succeeds', () => {
    const ways = [[10, 20], [12, 22], [30, 40], [7]].map((edges, i) => success([5], edges, i));
    expect(chooseReference(known, ways)).toEqual({ name: null, holds: [[12, 22]] });
    // held to the end, at tick 100
    expect(chooseReference(known, [success([5], [7])])).toEqual({ name: null, holds: [[7, 100]] });
    expect(chooseReference(known, [failure(0, 0, 0, 0)])).toEqual({ name: 'run 0', holds: [[0, 9]] });
    expect(chooseReference([], [failure(0, 0, 0, 0)])).toBeNull();
  });
});

describe('shares', () => {
  it('have the intervals that R. G. Newcombe published in 1998, method 3', () => {
    const published: [number, number, number, number][] = [
      [81, 263, 0.2553, 0.3662],
      [15, 148, 0.0624, 0.1605],
      [0, 20, 0, 0.1611],
      [1, 29, 0.0061, 0.1718],
    ];
    const attempts = (successes: number, all: number) =>
      Array.from({ length: all }, (_, i) => ({ ...failure(i, 0, 0, 0), ...(i < successes ? { cause: null } : {}) }));
    for (const [successes, all, low, high] of published) {
      const own = collectStatistics(shippedLevel('07-nova-lane'), DEFAULT_TERMS, attempts(successes, all));
      expect([own.low.toFixed(4), own.high.toFixed(4)]).toEqual([low.toFixed(4), high.toFixed(4)]);
    }
  });

  it('by attempt number count players, whatever the order of their plays', () => {
    // three players: the first succeeds at the second attempt, the next at once and again, the last never; one is not known
    const outcomes = ['0x', '0o', '1o', '1x', '1o', '2x', '2x', '2x', '?o'];
    const attempts = outcomes.map((text, i) => ({ ...failure(i, 0, 0, 0), ...(text[1] === 'o' ? { cause: null } : {}) }));
    const by = outcomes.map((text, i) => (text[0] === '?' ? null : { player: text[0], order: i }));
    const { byAttempt, players, playersWhoSucceed } = collectStatistics(
      shippedLevel('07-nova-lane'),
      DEFAULT_TERMS,
      attempts.toReversed(),
      {
        by,
      },
    );
    expect(byAttempt.map(({ attempts: all, successes, first }) => [all, successes, first])).toEqual([
      [3, 1, 1],
      [3, 1, 1],
      [2, 1, 0],
    ]);
    expect([players, playersWhoSucceed]).toEqual([3, 2]);
  });
});
