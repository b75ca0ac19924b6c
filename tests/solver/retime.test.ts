import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, type Scene, simulate } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { applyChange, certify, createRetime, findSlack, type Retime, type Retimed, verifyRun } from '../../solver/index.ts';
import '../fast-check.ts';
import { shippedLevel } from './shipped-level.ts';

const SLUGS = ['02-first-swing', '04-slingshot', '07-nova-lane', '13-pebbles', '16-firewalk', '17-watchdog'];

/** A shipped level with an asteroid moved, and what its first run was before. */
function moved(slug: string, index: number, dx: number, dy: number) {
  const level = shippedLevel(slug);
  const object = { kind: 'asteroid', index: index % level.asteroids.length } as const;
  const { x, y } = level.asteroids[object.index];
  const before = verifyRun(compile(level), level.runs[0].holds);
  if (before === null) throw new Error(slug);
  const change = { what: 'move', object, from: { x, y }, to: { x: x + dx, y: y + dy } } as const;
  return { level: applyChange(level, change), holds: level.runs[0].holds, before };
}

function finish(retime: Retime, most = 30_000_000): Retime {
  while (!retime.finished && retime.effort.ticks < most) retime.advance(50_000);
  return retime;
}

const shift = fc.integer({ min: -24, max: 24 });
const anyMove = fc.tuple(fc.constantFrom(...SLUGS), fc.nat(3), shift, shift);

/** How far edges are from others, each. */
const shifts = (holds: readonly Hold[], own: readonly Hold[]) => holds.flat().map((edge, i) => Math.abs(edge - own.flat()[i]));

/** The smallest shift of one edge with which the level is completed in time, by trying them all. */
function smallestSingle(level: Level, holds: readonly Hold[], until: number): number {
  const scene = compile(level);
  for (let by = 1; by <= 40; by++) {
    for (const sign of [by, -by]) {
      for (let i = 0; i < 2 * holds.length; i++) {
        const edges = holds.flat().map((edge, k) => (k === i ? edge + sign : edge));
        if (edges.some((edge, k) => edge < 0 || (k > 0 && edge <= edges[k - 1]))) continue;
        const script = holds.map((_, k): Hold => [edges[2 * k], edges[2 * k + 1]]);
        if (verifyRun(scene, script, { minerals: 'any' }, until) !== null) return by;
      }
    }
  }
  return Number.POSITIVE_INFINITY;
}

/** Those of them where all shifts at once are soon tried: elsewhere that takes a second each. */
const FORGIVING_LITTLE = ['02-first-swing', '04-slingshot', '07-nova-lane'];

/** What all shifts at once show of a result. */
function certified(scene: Scene, { holds, run }: Retimed): Retimed['certified'] {
  const goal = { minerals: run.minerals.length };
  const { ticks, exhausted } = certify(scene, holds, goal, { maxRuns: 20_000, limit: 12 });
  return { ticks, exhausted };
}

describe('holds near others that complete a changed level', () => {
  it('complete it in a simulation from the start, and are what they say they are', () => {
    fc.assert(
      fc.property(anyMove, ([slug, index, dx, dy]) => {
        const { level, holds, before } = moved(slug, index, dx, dy);
        const scene = compile(level);
        const certifies = FORGIVING_LITTLE.includes(slug);
        const { best } = finish(createRetime(scene, holds, { minerals: before.minerals, formerEnd: before.tick, certifies }));
        if (best === null) return;
        const run = simulate(scene, best.holds);
        expect(run.outcome).toBe('completed');
        expect(run.tick).toBe(best.run.tick);
        const collected = new Set(run.minerals.map((mineral) => mineral.index));
        expect(best.lost).toEqual(before.minerals.filter((mineral) => !collected.has(mineral)));
        const away = shifts(best.holds, holds);
        expect(best.edges).toBe(away.filter((by) => by > 0).length);
        expect(best.most).toBe(Math.max(...away));
        expect(best.total).toBe(away.reduce((sum, by) => sum + by, 0));
        expect(best.slack).toEqual(findSlack(scene, best.holds, { minerals: collected.size }));
        expect(best.certified).toEqual(certifies ? certified(scene, best) : null);
      }),
      { numRuns: 25 },
    );
  });

  it.each([
    ['where they forgive as much as is looked at', '01-first-pull', 0, { ticks: 12, exhausted: false }],
    ['where not all shifts are tried', '16-firewalk', 3, { exhausted: true }],
  ] as const)('have certified ticks %s', (_, slug, index, expected) => {
    const { level, holds } = moved(slug, index, -7, -6);
    const scene = compile(level);
    const { best } = finish(createRetime(scene, holds, { certifies: true }));
    expect(best?.certified).toMatchObject(expected);
    expect(best?.certified).toEqual(best && certified(scene, best));
  });

  it('are found wherever one press or release alone is enough, and are shifted no more before they are centred', () => {
    fc.assert(
      fc.property(anyMove, ([slug, index, dx, dy]) => {
        const { level, holds, before } = moved(slug, index, dx, dy);
        const scene = compile(level);
        if (verifyRun(scene, holds) !== null) return;
        const single = smallestSingle(level, holds, before.tick + 300);
        const { best } = finish(createRetime(scene, holds, { formerEnd: before.tick, centres: false }));
        if (single < Number.POSITIVE_INFINITY) expect(best?.total).toBeLessThanOrEqual(single);
      }),
      { numRuns: 25 },
    );
  });

  it('are the given ones where these complete the level still', () => {
    const level = shippedLevel('02-first-swing');
    const { best } = finish(createRetime(compile(level), level.runs[0].holds));
    expect(best).toMatchObject({ holds: level.runs[0].holds, edges: 0, most: 0, total: 0 });
  });

  it('are the given ones again when she is back, whatever worked in between', () => {
    const level = shippedLevel('02-first-swing');
    const [[press, release]] = level.runs[0].holds;
    const warm: Hold[] = [[press + 1, release + 2]];
    const { best } = finish(createRetime(compile(level), level.runs[0].holds, { warm }));
    expect(best?.total).toBe(0);
  });

  it('are found sooner from holds that worked a moment ago', () => {
    const { level, holds, before } = moved('15-three-swings', 1, 8, 8);
    const scene = compile(level);
    const first = (warm: readonly Hold[] | null) => {
      const retime = createRetime(scene, holds, { minerals: before.minerals, formerEnd: before.tick, warm });
      while (!retime.finished && retime.best === null) retime.advance(1);
      return { ticks: retime.effort.ticks, holds: retime.best?.holds ?? null };
    };
    const cold = first(null);
    expect(cold.holds).not.toBeNull();
    expect(first(cold.holds).ticks).toBeLessThan(cold.ticks / 4);
  });

  it('are the same however the work is split', () => {
    const { level, holds, before } = moved('04-slingshot', 1, 8, 8);
    const of = (slice: number) => {
      const retime = createRetime(compile(level), holds, { minerals: before.minerals, formerEnd: before.tick });
      for (let asked = 0; asked < 300_000 && !retime.finished; asked += slice) retime.advance(slice);
      return { best: retime.best, effort: retime.effort, finished: retime.finished };
    };
    expect(of(1000)).toEqual(of(300_000));
    expect(of(7500)).toEqual(of(300_000));
  });

  it('never go farther than the limit, nor before the start', () => {
    fc.assert(
      fc.property(anyMove, fc.integer({ min: 1, max: 12 }), ([slug, index, dx, dy], within) => {
        const { level, holds, before } = moved(slug, index, dx, dy);
        const { best } = finish(createRetime(compile(level), holds, { formerEnd: before.tick, within }), 200_000);
        if (best === null) return;
        expect(Math.max(...shifts(best.holds, holds))).toBeLessThanOrEqual(within);
        expect(Math.min(...best.holds.flat())).toBeGreaterThanOrEqual(0);
      }),
      { numRuns: 20 },
    );
  });

  it('cannot be found for a run without holds, and that is known at once', () => {
    const level = shippedLevel('02-first-swing');
    const retime = finish(createRetime(compile(level), []));
    expect(retime).toMatchObject({ best: null, finished: true });
  });
});
