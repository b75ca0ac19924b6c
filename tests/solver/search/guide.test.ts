import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, STATE_SIZE } from '../../../engine/index.ts';
import { createRandom, createSearch } from '../../../solver/index.ts';
import { Frontier } from '../../../solver/search/explore/frontier.ts';
import { Guide, NO_WAY, WayMap } from '../../../solver/search/explore/guide.ts';
import { LineOfFlight } from '../../../solver/search/explore/line-of-flight.ts';
import { plainLevel } from '../../engine/plain-level.ts';
import { arbitraryOrdinaryLevel, fallThrough } from './solvable-levels.ts';

/** A wall between her and the black hole, with a door at `y`. */
const door = (y: number) =>
  plainLevel({
    range: 250,
    asteroids: [{ x: 100, y: 0, radius: 16 }],
    blackHole: { x: 230, y: 0 },
    novae: Array.from({ length: 36 }, (_, i) => 16 * i - 288)
      .filter((nova) => Math.abs(nova - y) > 40)
      .map((nova) => ({ x: 120, y: nova, radius: 16 })),
  });

const mapOf = (level: ReturnType<typeof plainLevel>): WayMap => {
  const map = WayMap.of(compile(level, 'precise'));
  if (map === null) throw new Error('expected a map, found none');
  return map;
};

describe('a map of ways', () => {
  it('measures the ways that relaxing every step until nothing changes finds', () => {
    fc.assert(
      fc.property(arbitraryOrdinaryLevel, (level) => {
        const map = mapOf(level);
        const { x, y } = level.blackHole;
        const field = map.fieldTo(x, y, 40);
        const { width } = map;
        const slow = new Int32Array(field.length).fill(NO_WAY);
        for (let i = 0; i < field.length; i++) if (field[i] === 0) slow[i] = 0;
        for (let changed = true; changed; ) {
          changed = false;
          for (let i = 0; i < slow.length; i++) {
            if (!map.isFree(i)) continue;
            for (const dx of [-1, 0, 1]) {
              for (const dy of [-width, 0, width]) {
                const from = slow[i + dx + dy];
                const length = from + (dx !== 0 && dy !== 0 ? 7 : 5);
                if (from === NO_WAY || length >= slow[i] || (dx === 0 && dy === 0)) continue;
                slow[i] = length;
                changed = true;
              }
            }
          }
        }
        expect(field).toEqual(slow);
      }),
      { numRuns: 10 },
    );
  });

  it('leads through the door, and nowhere if there is none', () => {
    const { x, y } = door(0).blackHole;
    const lengthFor = (at: number) => {
      const map = mapOf(door(at));
      const field = map.fieldTo(x, y, 37);
      return (field[map.squareAt(0, 0)] * map.size) / 5;
    };
    expect(Math.abs(lengthFor(0) - 193)).toBeLessThan(16);
    const around = Math.hypot(120, 150) + Math.hypot(110, 150) - 37;
    expect(lengthFor(150)).toBeGreaterThan(around - 40);
    expect(lengthFor(150)).toBeLessThan(1.2 * around);
    expect(mapOf(door(1000)).fieldTo(x, y, 37)[mapOf(door(1000)).squareAt(0, 0)]).toBe(NO_WAY);
  });

  it('is left out where the level is too large', () => {
    expect(WayMap.of(compile(plainLevel({ range: 1e6 }), 'precise'))).toBeNull();
  });
});

describe('a guide', () => {
  it('sees the door ahead of her, and no door where a wall is', () => {
    const scene = compile(door(0), 'precise');
    const guide = Guide.of(scene, 0);
    if (guide === null) throw new Error('expected a guide, found none');
    const line = new LineOfFlight(scene);
    const here = guide.bandAt(0, 0, 0);
    const ahead = (vx: number, vy: number) => {
      const state = new Float64Array(STATE_SIZE);
      state.set([0, 0, vx, vy, 1, 0]);
      return guide.bandAhead(state, 0, here, line);
    };
    expect(ahead(50, 0)).toBe(0);
    expect(ahead(-50, 0)).toBeGreaterThan(here);
    expect(ahead(20, 50)).toBeGreaterThan(0);
    expect(ahead(0, 0)).toBeGreaterThan(here);
  });
});

describe('a frontier', () => {
  it('gives strata effort in proportion to 1 / (2 + n), whatever a stretch costs', () => {
    const frontier = new Frontier();
    const random = createRandom(1);
    for (const stratum of [40, 7, 12]) frontier.add(stratum, stratum, true);
    const spent = new Map<number, number>();
    for (let i = 0; i < 10_000; i++) {
      const stratum = frontier.least();
      const ticks = 1 + random.below(200);
      frontier.spend(stratum, ticks);
      spent.set(stratum, (spent.get(stratum) ?? 0) + ticks);
    }
    const shares = [7, 12, 40].map((stratum, n) => (spent.get(stratum) ?? 0) * (2 + n));
    for (const share of shares) expect(Math.abs(share / shares[0] - 1)).toBeLessThan(0.02);
  });

  it('gives each node once for a press and once for a coast, and all again with smaller cells', () => {
    const frontier = new Frontier();
    const random = createRandom(1);
    for (let node = 0; node < 20; node++) frontier.add(node, 3, node !== 5);
    const taken = (held: boolean) => {
      const nodes: number[] = [];
      for (let node = 0; node >= 0; ) {
        node = frontier.take(3, held, random, 4, (n) => n);
        if (node >= 0) nodes.push(node);
      }
      return nodes.sort((a, b) => a - b);
    };
    const open = Array.from({ length: 20 }, (_, i) => i).filter((i) => i !== 5);
    expect(taken(true)).toEqual(open);
    expect(taken(true)).toEqual([]);
    expect(taken(false)).toEqual(open);
    expect([...frontier.refine(3)]).toEqual(Array.from({ length: 20 }, (_, i) => i));
    expect(frontier.refinedOf(3)).toBe(1);
    expect(taken(true)).toEqual([]);
  });
});

describe('a search that the guided one has joined', () => {
  it('gives the same result however it is advanced', () => {
    const wall = [-60, -30, 0, 30, 60].map((y) => ({ id: null, x: 190, y, radius: 16 }));
    const level = { ...fallThrough(), novae: [...wall, ...wall.map((o) => ({ ...o, x: 270 }))] };
    const scene = compile(level, 'arcade');
    for (const minerals of ['any', 'all'] as const) {
      const view = (parts: readonly number[]) => {
        const search = createSearch(scene, { seed: 4, goal: { minerals } });
        for (const ticks of parts) search.advance(ticks);
        const { solutions, effort, closest, explored } = search;
        return { solutions, effort, closest, explored };
      };
      const whole = view([620_000]);
      expect(view([499_990, 7, 20_003, 50_000, 49_999, 1])).toEqual(whole);
      expect(whole.effort.ticks).toBeGreaterThanOrEqual(620_000);
    }
  });
});
