import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { alignEdges, Tally } from '../../check/plays/edges.ts';
import { dbscan } from '../../check/plays/failures.ts';
import type { PlayStatistics } from '../../check/plays/index.ts';
import { ACCURACIES, DEFAULT_TERMS } from '../../engine/index.ts';
import type { Play } from '../../game/index.ts';
import type { Place } from '../../schema/basics/index.ts';
import { type Hold, readLevel } from '../../schema/index.ts';
import { noisy, playedBy, shippedLevel, statisticsOf } from './played.ts';

/** DBSCAN as its authors wrote it, but that border points choose the nearest core point: every pair is compared. */
function plainDbscan(points: readonly Place[], reach: number, least: number): number[] {
  const squared = (a: Place, b: Place) => (a.x - b.x) ** 2 + (a.y - b.y) ** 2;
  const isNear = (a: Place, b: Place) => squared(a, b) <= reach * reach;
  const isCore = points.map((a) => points.filter((b) => isNear(a, b)).length >= least);
  const labels = points.map(() => -1);
  let next = 0;
  for (const [i] of points.entries()) {
    if (!isCore[i] || labels[i] >= 0) continue;
    const label = next++;
    const waiting = [i];
    for (let at = waiting.pop(); at !== undefined; at = waiting.pop()) {
      labels[at] = label;
      for (const [k, other] of points.entries()) if (isCore[k] && labels[k] < 0 && isNear(points[at], other)) waiting.push(k);
    }
  }
  return points.map((point, i) => {
    if (isCore[i]) return labels[i];
    const cores = [...points.keys()].filter((k) => isCore[k] && isNear(point, points[k]));
    const order = (a: number, b: number) =>
      squared(point, points[a]) - squared(point, points[b]) || points[a].x - points[b].x || points[a].y - points[b].y;
    return cores.length === 0 ? -1 : labels[cores.sort(order)[0]];
  });
}

/** Renumbers clusters by their first point. */
const renumbered = (labels: Iterable<number>): number[] => {
  const names = new Map<number, number>([[-1, -1]]);
  return [...labels].map((label) => {
    if (!names.has(label)) names.set(label, names.size - 1);
    return names.get(label) as number;
  });
};

describe('dbscan', () => {
  const at = (x: number, y: number): Place => ({ x, y });
  const place = fc.record({ x: fc.integer({ min: -60, max: 60 }), y: fc.integer({ min: -60, max: 60 }) });

  it('finds the clusters that a comparison of all pairs finds', () => {
    const least = fc.integer({ min: 1, max: 6 });
    const points = fc.array(place, { maxLength: 80 });
    fc.assert(
      fc.property(points, fc.constantFrom(7, 10, 25), least, (some, reach, enough) => {
        expect(renumbered(dbscan(some, reach, enough))).toEqual(renumbered(plainDbscan(some, reach, enough)));
      }),
      { numRuns: 300 },
    );
  });

  it('a point between two clusters, as near to one as to the other, belongs to that with the lower x', () => {
    const right = [at(15, -20), at(16, -30), at(20, -30)];
    const left = [at(-15, 20), at(-16, 30), at(-20, 30)];
    const [middle, ...others] = dbscan([at(0, 0), ...right, ...left], 25, 4);
    expect(others.slice(3)).toEqual([middle, middle, middle]);
    expect(others.slice(0, 3)).not.toContain(middle);
  });
});

describe('alignEdges', () => {
  const edges = fc.uniqueArray(fc.integer({ min: 0, max: 400 }), { maxLength: 5 }).map((ticks) => ticks.sort((a, b) => a - b));

  /** The cost of the cheapest alignment, every one tried. */
  const cheapest = (reference: readonly number[], own: readonly number[]): number => {
    const from = (i: number, j: number): number => {
      const rest = 60 * (own.length - j);
      if (i === reference.length || j === own.length) return rest;
      const ways = [rest, 30 + from(i + 1, j), 60 + from(i, j + 1)];
      if ((i - j) % 2 === 0) ways.push(Math.abs(reference[i] - own[j]) + from(i + 1, j + 1));
      return Math.min(...ways);
    };
    return from(0, 0);
  };

  const costOf = (reference: readonly number[], own: readonly number[], partners: Int32Array): number => {
    const paired = [...partners.keys()].filter((i) => partners[i] >= 0);
    const reached = (paired.at(-1) ?? -1) + 1;
    const alone = 30 * (reached - paired.length) + 60 * (own.length - paired.length);
    return alone + paired.reduce((sum, i) => sum + Math.abs(reference[i] - own[partners[i]]), 0);
  };

  it('is as cheap as the cheapest, in order, and never pairs a press with a release', () => {
    fc.assert(
      fc.property(edges, edges, (reference, own) => {
        const partners = alignEdges(reference, own);
        expect(costOf(reference, own, partners)).toBe(cheapest(reference, own));
        const paired = [...partners].flatMap((partner, i) => (partner < 0 ? [] : [[i, partner]]));
        expect(paired.every(([i, partner]) => (i - partner) % 2 === 0)).toBe(true);
        expect(paired.map(([, partner]) => partner)).toEqual(paired.map(([, partner]) => partner).sort((a, b) => a - b));
      }),
    );
  });

  it('skips a tap between, and a press that was missed', () => {
    expect([...alignEdges([100, 200], [98, 130, 150, 203])]).toEqual([0, 3]);
    expect([...alignEdges([100, 110, 300, 400], [301, 390])]).toEqual([-1, -1, 0, 1]);
    expect([...alignEdges([100, 200, 300, 400], [104, 199])]).toEqual([0, 1, -1, -1]);
    // as far off as an edge without a partner costs
    expect([...alignEdges([100], [159]), ...alignEdges([100], [160])]).toEqual([0, -1]);
  });
});

describe('quartiles', () => {
  it('are those of R, as published for its default type 7', () => {
    const tally = new Tally();
    // quantile(c(1, 2, 3, 4, 5, 6, 7, 8, 9, 10)): 25% 3.25, 50% 5.50, 75% 7.75
    for (let i = 1; i <= 10; i++) tally.add(i);
    expect(tally.quartiles()).toEqual({ count: 10, low: 3.25, median: 5.5, high: 7.75 });
    expect(new Tally().quartiles()).toBeNull();
  });
});

const SWING = shippedLevel('02-first-swing');
const play = playedBy(SWING);
const [RUN] = SWING.runs;

describe('statisticsOf', () => {
  const some = noisy(RUN.holds, 250, 120, 1).map((holds) => play(holds));

  it('counts what happened, and every play once', () => {
    const result = statisticsOf(SWING, DEFAULT_TERMS, some);
    const completed = some.filter(({ claim }) => claim.outcome === 'completed').length;
    expect(result).toMatchObject({ attempts: 120, successes: completed, players: 1, playersWhoSucceed: 1, refused: [] });
    const failures = 120 - completed;
    const sum = (counts: readonly number[]) => counts.reduce((a, b) => a + b, 0);
    expect(sum(result.causes.map(({ count }) => count))).toBe(failures);
    expect(sum(result.failureTimes)).toBe(failures);
    expect(sum(result.edges.map(({ failed }) => failed))).toBe(failures);
    expect(sum(result.routes.map(({ count }) => count))).toBe(completed);
    expect(result.edges[0].reached).toBe(120);
    expect(result.reference?.name).toBe(RUN.name);
  });

  it('says why each fails, when, and how many minerals the others have', () => {
    const rest = readLevel(
      JSON.stringify({
        ...{ version: 1, name: 'Rest', astronaut: { x: 0, y: 0 }, blackHole: { x: 170, y: 0 } },
        ...{
          asteroids: [{ x: 100, y: 0, radius: 16 }],
          minerals: [
            { x: 20, y: 0 },
            { x: 0, y: 500 },
          ],
        },
        runs: [
          { name: 'own', holds: [[0, 600]] },
          { name: 'same', holds: [[0, 500]] },
        ],
      }),
    );
    if (!rest.ok) throw new Error('not a valid level');
    const record = playedBy(rest.level);
    const plays = [record([]), record([], 30), record([], 90), record([], 0), record([[9, 600]]), record([[0, 600]])];
    const found = statisticsOf(rest.level, DEFAULT_TERMS, plays);
    expect(found).toMatchObject({ attempts: 6, successes: 2, minerals: [0, 2, 0], refused: [] });
    expect(found.causes).toEqual([
      { cause: { kind: 'left', index: null }, count: 3, share: 0.75 },
      { cause: { kind: 'timeout', index: null }, count: 1, share: 0.25 },
    ]);
    expect(found.failureTimes.slice(0, 2)).toEqual([2, 1]);
    expect(found.failureTimes[60]).toBe(1);
    // the quickest, which is held to its end, by the name of the first run
    expect(found.routes).toMatchObject([{ asteroids: [0], count: 2, share: 1, play: 5, run: 'own' }]);
    expect(found.all[5].edges).toEqual([0]);
    expect(found.reference?.name).toBe('own');
    // one way, however often the button is pressed
    expect(
      statisticsOf(rest.level, DEFAULT_TERMS, [
        record([
          [0, 3],
          [6, 600],
        ]),
      ]).routes.map(({ asteroids }) => asteroids),
    ).toEqual([[0]]);
    const demanding = (minerals: number) => statisticsOf(rest.level, DEFAULT_TERMS, plays, { goal: { minerals } });
    expect(demanding(1).successes).toBe(2);
    expect(demanding(2).causes.map(({ cause, count }) => [cause.kind, count])).toEqual([
      ['left', 3],
      ['minerals', 2],
      ['timeout', 1],
    ]);
  });

  it('a play of a level that ends at once may be left before its first tick', () => {
    const inside = readLevel(
      JSON.stringify({ version: 1, name: 'In', astronaut: { x: 0, y: 0 }, blackHole: { x: 5, y: 0 }, asteroids: [] }),
    );
    if (!inside.ok) throw new Error('not a valid level');
    const record = playedBy(inside.level);
    const { all, refused } = statisticsOf(inside.level, DEFAULT_TERMS, [record([], 0), record([])]);
    expect(refused).toEqual([]);
    expect(all.map(({ outcome }) => outcome)).toEqual(['left', 'completed']);
  });

  it('does not trust a claim, and names plays that differ from theirs', () => {
    const [own] = some;
    const lies: Play[] = [
      { ...own, claim: { ...own.claim, tick: own.claim.tick - 1 } },
      { ...own, claim: { ...own.claim, outcome: own.claim.outcome === 'completed' ? 'lost' : 'completed' } },
      { ...own, claim: { ...own.claim, minerals: own.claim.minerals + 1 } },
      { ...own, claim: { ...own.claim, tick: 10 ** 9 } },
      { ...own, level: '0'.repeat(64) },
      { ...own, engine: '0'.repeat(16) },
      { ...own, accuracy: 'arcade' },
    ];
    const result = statisticsOf(SWING, DEFAULT_TERMS, [...lies, own]);
    expect(result.attempts).toBe(1);
    expect(result.refused.map(({ play: index, verdict }) => [index, verdict])).toEqual([
      [0, 'claim-differs'],
      [1, 'claim-differs'],
      [2, 'claim-differs'],
      [3, 'too-long'],
      [4, 'stale-level'],
      [5, 'unknown-engine'],
      [6, 'other-accuracy'],
    ]);
  });

  it('counts plays under its terms alone', () => {
    const arcade = { ...DEFAULT_TERMS, accuracy: ACCURACIES.arcade };
    const coarse = playedBy(SWING, 'arcade')(RUN.holds);
    expect(statisticsOf(SWING, arcade, [coarse, some[0]])).toMatchObject({
      attempts: 1,
      refused: [{ play: 1, verdict: 'other-accuracy', message: 'expected a play at the accuracy arcade, found one at precise' }],
    });
    const short = { ...DEFAULT_TERMS, maxTime: (some[0].claim.tick - 1) / 60 };
    expect(statisticsOf(SWING, short, [some[0]]).refused).toMatchObject([{ verdict: 'too-long' }]);
    expect(statisticsOf(SWING, { ...DEFAULT_TERMS, maxWork: 2 }, [some[0]]).refused).toMatchObject([{ verdict: 'too-long' }]);
    // and so does the level's own run that players are compared with
    expect(statisticsOf(SWING, { ...DEFAULT_TERMS, maxTime: 1 }, []).reference).toBeNull();
  });

  it('is the same for any order of the plays', () => {
    const by = some.map((_, i) => ({ player: `player ${i % 7}`, order: i }));
    const bare = ({ all, refused, clusters, routes, ...rest }: PlayStatistics) => ({
      ...rest,
      clusters: clusters.map(({ plays, ...cluster }) => cluster),
      routes: routes.map(({ play: quickest, ...route }) => route),
    });
    const once = bare(statisticsOf(SWING, DEFAULT_TERMS, some, { by }));
    fc.assert(
      fc.property(fc.shuffledSubarray([...some.keys()], { minLength: some.length }), (order) => {
        const shuffled = statisticsOf(
          SWING,
          DEFAULT_TERMS,
          order.map((i) => some[i]),
          { by: order.map((i) => by[i]) },
        );
        expect(bare(shuffled)).toEqual(once);
      }),
      { numRuns: 5 },
    );
  });

  it('has nothing to say without plays', () => {
    expect(statisticsOf(SWING, DEFAULT_TERMS, [])).toMatchObject({
      attempts: 0,
      share: 0,
      low: 0,
      high: 1,
      clusters: [],
      routes: [],
      byAttempt: [],
    });
  });

  it('a player who never presses fails at the start', () => {
    const none: readonly Hold[] = [];
    const { edges } = statisticsOf(SWING, DEFAULT_TERMS, [play(none), play(none, 30)]);
    expect(edges[0]).toMatchObject({ type: 'start', reached: 2, failed: 2, share: 1 });
    const [[press, release]] = RUN.holds;
    expect(edges.map(({ type, hold, tick }) => [type, hold, tick])).toEqual([
      ['start', 0, 0],
      ['press', 0, press],
      ['release', 0, release],
    ]);
    expect(edges.slice(1).every(({ reached }) => reached === 0)).toBe(true);
  });
});
