import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Attempt, collectStatistics, compareWithModel, statisticsOf } from '../../check/plays/index.ts';
import { decreasing, explainingNoise } from '../../check/plays/model.ts';
import { compile } from '../../engine/index.ts';
import { createRandom } from '../../solver/index.ts';
import { isHunt } from '../is-hunt.ts';
import { noisy, playedBy, shippedLevel } from './played.ts';

const ANY = { minerals: 'any' } as const;

/** What `count` players do whose timing noise is `sigma` ms, and what the model makes of it. */
function play(slug: string, sigma: number, count: number, seed: number) {
  const level = shippedLevel(slug);
  const [{ holds, name }] = level.runs;
  const record = playedBy(level, 'fast');
  const plays = noisy(holds, sigma, count, seed).map((own) => record(own));
  const statistics = statisticsOf(level, plays, { reference: { holds, name } });
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

  it('is not what explains players who miss one press only, and the comparison says which', () => {
    const level = shippedLevel('14-run-up');
    const [{ holds, name }] = level.runs;
    const record = playedBy(level, 'fast');
    const random = createRandom(5);
    const late = 1;
    const plays = Array.from({ length: 200 }, () => {
      const delay = random.below(2) === 0 ? 0 : 20 + random.below(60);
      return record(holds.map(([press, release], i) => (i === late ? [press + delay, release + delay] : [press, release])));
    });
    const statistics = statisticsOf(level, plays, { reference: { holds, name } });
    expect(statistics.share).toBeLessThan(0.9);
    const { edges } = compareWithModel(compile(level, 'fast'), holds, statistics, ANY, { samples: 300 });
    const failing = statistics.edges.flatMap(({ failed }, i) => (failed > 10 ? [i] : []));
    expect(failing.length).toBeGreaterThan(0);
    // none fails before the first press that is late
    expect(failing.every((i) => i >= 2 * late)).toBe(true);
    expect(failing.map((i) => edges[i].players)).toContain('more');
  });

  it('is 0 where the run itself takes longer than an attempt may last', () => {
    const level = shippedLevel('14-run-up');
    const [{ holds, name }] = level.runs;
    const record = playedBy(level, 'fast');
    const plays = noisy(holds, 80, 20, 1).map((own) => record(own));
    const statistics = statisticsOf(level, plays, { reference: { holds, name } });
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

  it('a failure more changes only the cluster that it is in, and shares', () => {
    const some = [0, 1, 2, 3, 4, 5].map((i) => failure(i, 10 * i, 0, 0));
    const other = [6, 7, 8, 9].map((i) => failure(i, 900 + i, 0, 1));
    const before = collectStatistics(level, [...some, ...other]).clusters;
    const after = collectStatistics(level, [...some, ...other, failure(10, 905, 1, 1)]).clusters;
    expect(before.map(({ count }) => count)).toEqual([6, 4]);
    expect(after.map(({ count }) => count)).toEqual([6, 5]);
    expect({ ...after[0], share: 0 }).toEqual({ ...before[0], share: 0 });
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
      const own = collectStatistics(shippedLevel('07-nova-lane'), attempts(successes, all));
      expect([own.low.toFixed(4), own.high.toFixed(4)]).toEqual([low.toFixed(4), high.toFixed(4)]);
    }
  });

  it('by attempt number count players, whatever the order of their plays', () => {
    // three players: the first succeeds at the second attempt, the next at once and again, the last never; one is not known
    const outcomes = ['0x', '0o', '1o', '1x', '1o', '2x', '2x', '2x', '?o'];
    const attempts = outcomes.map((text, i) => ({ ...failure(i, 0, 0, 0), ...(text[1] === 'o' ? { cause: null } : {}) }));
    const by = outcomes.map((text, i) => (text[0] === '?' ? null : { player: text[0], order: i }));
    const { byAttempt, players, playersWhoSucceed } = collectStatistics(shippedLevel('07-nova-lane'), attempts.toReversed(), {
      by,
    });
    expect(byAttempt.map(({ attempts: all, successes, first }) => [all, successes, first])).toEqual([
      [3, 1, 1],
      [3, 1, 1],
      [2, 1, 0],
    ]);
    expect([players, playersWhoSucceed]).toEqual([3, 2]);
  });
});
