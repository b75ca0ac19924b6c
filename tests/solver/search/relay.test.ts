import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { makeChain } from '../../../bench/chains/index.ts';
import { compile } from '../../../engine/index.ts';
import { createSearch } from '../../../solver/index.ts';
import { RelaySearch } from '../../../solver/search/relay-search.ts';
import { Reports } from '../../../solver/search/reports.ts';
import { STAGES, Stages } from '../../../solver/search/stages.ts';
import { WayMap } from '../../../solver/search/way-map.ts';
import { createReplay } from '../../../solver/verified-run.ts';
import { plainLevel } from '../../engine/plain-level.ts';
import { arbitraryOrdinaryLevel } from './solvable-levels.ts';

const mapOf = (level: ReturnType<typeof plainLevel>): WayMap => {
  const map = WayMap.of(compile(level, 'precise'));
  if (map === null) throw new Error('expected a map, found none');
  return map;
};

describe('stages', () => {
  it('count the asteroids in a row that are still to be passed', () => {
    const xs = [0, 200, 400, 600];
    const level = plainLevel({ range: 250, asteroids: xs.map((x) => ({ x, y: 0, radius: 16 })), blackHole: { x: 640, y: 0 } });
    const stages = new Stages(compile(level, 'precise'), mapOf(level), 0);
    for (const [i, x] of xs.entries()) {
      for (const aside of [-80, 0, 80]) expect(stages.at(x + aside, aside / 2, 0)).toBe(xs.length - 1 - i);
    }
    expect(stages.at(5000, 0, 0)).toBe(STAGES - 1);
  });

  it('count borders to the nearest of the missing minerals', () => {
    const xs = [0, 200, 400, 600];
    const minerals = [
      { x: 0, y: 50, radius: 7 },
      { x: 600, y: 50, radius: 7 },
    ];
    const level = plainLevel({
      range: 250,
      asteroids: xs.map((x) => ({ x, y: 0, radius: 16 })),
      blackHole: { x: 640, y: 0 },
      minerals,
    });
    const stages = new Stages(compile(level, 'precise'), mapOf(level), minerals.length);
    expect(xs.map((x) => stages.at(x, 0, 0b01))).toEqual([0, 1, 2, 3]);
    expect(xs.map((x) => stages.at(x, 0, 0b10))).toEqual([3, 2, 1, 0]);
    expect(xs.map((x) => stages.at(x, 0, 0b11))).toEqual([0, 1, 1, 0]);
  });

  it('are as many as the fewest changes of the nearest asteroid on any way, found by relaxing every step', () => {
    fc.assert(
      fc.property(arbitraryOrdinaryLevel, (level) => {
        const map = mapOf(level);
        const stages = new Stages(compile(level, 'precise'), map, 0);
        const nearest = new Array<number>(map.squares).fill(-1);
        const least = new Float64Array(map.squares).fill(Number.POSITIVE_INFINITY);
        // cold asteroids come first
        const rocks = [...level.asteroids.filter(({ hot }) => !hot), ...level.asteroids.filter(({ hot }) => hot)];
        for (const [i, { x, y }] of rocks.entries()) {
          map.each(x, y, level.range, (square, dx, dy) => {
            if (dx * dx + dy * dy >= least[square]) return;
            least[square] = dx * dx + dy * dy;
            nearest[square] = i;
          });
        }
        const slow = new Int32Array(map.squares).fill(STAGES - 1);
        const { blackHole } = level;
        map.each(blackHole.x, blackHole.y, blackHole.radius + compile(level, 'precise').box.halfDiagonal, (square) => {
          if (map.isFree(square)) slow[square] = 0;
        });
        const { width } = map;
        const all = [1, -1, width, -width, width + 1, width - 1, 1 - width, -width - 1];
        for (let changed = true; changed; ) {
          changed = false;
          for (let i = 0; i < slow.length; i++) {
            if (!map.isFree(i)) continue;
            for (const step of all) {
              const next = i + step;
              if (!map.isFree(next)) continue;
              const count = slow[next] + (nearest[next] === nearest[i] ? 0 : 1);
              if (count >= slow[i]) continue;
              slow[i] = count;
              changed = true;
            }
          }
        }
        const found = Array.from(slow, (_, i) => (map.isFree(i) ? stages.ofSquare(i, 0) : STAGES - 1));
        expect(found).toEqual([...slow]);
      }),
      { numRuns: 10 },
    );
  });
});

describe('a search from border to border', () => {
  const search = (seed: number) => {
    const { level } = makeChain('turns', 2, 1);
    const scene = compile(level, 'precise');
    const maxTicks = 3600;
    const reports = new Reports(createReplay(scene, { minerals: 'any' }, maxTicks));
    const map = mapOf(level);
    const relay = new RelaySearch({ scene, needed: 0, maxTicks, after: null, reports }, seed, new Stages(scene, map, 0));
    while (reports.solutions.length === 0 && relay.effort.ticks < 3_000_000 && relay.step());
    return { solutions: reports.solutions, effort: relay.effort, closest: relay.closest };
  };

  it('passes two doors, the same way for the same seed', () => {
    const found = search(1);
    expect(found.solutions.length).toBe(1);
    expect(search(1)).toEqual(found);
    expect(search(2).solutions.length).toBe(1);
  });

  it('gets on however short a run may be', () => {
    const level = plainLevel({
      range: 250,
      asteroids: [
        { x: 0, y: 0, radius: 16 },
        { x: 200, y: 0, radius: 16 },
      ],
      blackHole: { x: 300, y: 0 },
    });
    const scene = compile(level, 'precise');
    const reports = new Reports(createReplay(scene, { minerals: 'any' }, 1));
    const relay = new RelaySearch({ scene, needed: 0, maxTicks: 1, after: null, reports }, 1, new Stages(scene, mapOf(level), 0));
    while (relay.effort.ticks < 1000) expect(relay.step()).toBe(true);
    expect(reports.solutions).toEqual([]);
  });
});

describe('a search that all lanes have joined', () => {
  it('gives the same result however it is advanced', () => {
    const scene = compile(
      plainLevel({
        range: 150,
        asteroids: [
          { x: 0, y: 0, radius: 16 },
          { x: 200, y: 0, radius: 16 },
        ],
        blackHole: { x: 250, y: 0 },
        novae: [-48, -16, 16, 48].flatMap((y) => [200, 300].map((x) => ({ x, y, radius: 32 }))),
      }),
      'arcade',
    );
    const view = (parts: readonly number[]) => {
      const search = createSearch(scene, { seed: 4 });
      for (const ticks of parts) search.advance(ticks);
      const { solutions, effort, closest, explored, latest } = search;
      return { solutions, effort, closest, explored, latest };
    };
    const whole = view([3_200_000]);
    expect(whole.solutions).toEqual([]);
    expect(whole.effort.ticks).toBeGreaterThanOrEqual(3_200_000);
    expect(view([2_999_990, 7, 20_003, 100_000, 79_999, 1])).toEqual(whole);
  });
});
