import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, createSimulation } from '../../../engine/index.ts';
import { DEFAULT_RULES } from '../../../schema/index.ts';
import { afterChase, type Chaser, eitherChaser } from '../../../solver/verify/chasers.ts';
import { expectDeep } from '../../depth.ts';
import { at, levelWith, type NearMiss, nearMisses, ORIGIN } from './near-miss.ts';

/** The acceleration of an alien, px/s², and the distance below which it sees her, px. */
const CHASE = 8;
const SIGHT = 150;

const alien = (
  x: number,
  y: number,
  more: { radius?: number; within?: number; v?: readonly [number, number]; blur?: number } = {},
): Chaser => ({
  at: { centre: { x, y }, within: more.within ?? 0 },
  speed: { centre: { x: more.v?.[0] ?? 0, y: more.v?.[1] ?? 0 }, within: more.blur ?? 0 },
  radius: more.radius ?? 25,
  isThere: true,
});
const area = (left: number, right: number, low: number, high: number) => ({ left, right, low, high });
const here = area(0, 0, 0, 0);
const T = 4 / 60;
const one = (chaser: Chaser, where = here, seconds = T): Chaser => afterChase(DEFAULT_RULES, [chaser], where, seconds)[0];
const inside = (disc: { centre: { x: number; y: number }; within: number }, x: number, y: number): number =>
  Math.hypot(disc.centre.x - x, disc.centre.y - y) - disc.within;

describe('how an alien moves', () => {
  const wakes = (chaser: (d: number) => Chaser, truth: number, where = here): NearMiss => ({
    why: (d) => (one(chaser(d), where) === chaser(d) || one(chaser(d), where).at.within === chaser(d).at.within ? null : 'wakes'),
    truth,
    safe: 'above',
    slack: [5e-8, 2e-7],
    says: 'wakes',
  });
  nearMisses({
    'one that stands sleeps when she is farther away than it sees': wakes((d) => alien(d, 0), SIGHT),
    'in any direction': wakes((d) => alien(-0.6 * d, 0.8 * d), SIGHT),
    'and so it does wherever it may be': wakes((d) => alien(0, -d, { within: 7 }), SIGHT + 7),
    'and wherever she may be': wakes((d) => alien(0, -d), SIGHT + 5, area(-3, 3, -4, 4)),
    'and where she may be is not about the origin': wakes((d) => alien(10, 20 + d), SIGHT + 5, area(7, 13, 16, 24)),
  });

  it('one that sees her is drawn to her', () => {
    const after = one(alien(60, 80));
    expect(inside(after.speed, -0.6 * CHASE * T, -0.8 * CHASE * T)).toBeLessThan(0);
    expect(inside(after.at, 60 - (0.6 * CHASE * T * T) / 2, 80 - (0.8 * CHASE * T * T) / 2)).toBeLessThan(0);
    // It moves 0.018 px itself, which is the only uncertainty.
    expect(after.speed.within).toBeLessThan(2e-4);
    expect(after.at.within).toBeLessThan(5e-6);
    expect(after.isThere).toBe(true);
  });

  it('a moving one goes on, and may be pulled or not where it is unknown whether it sees her', () => {
    const moving = alien(SIGHT + 0.3, 0, { v: [6, 3] });
    const after = one(moving);
    // It may stop dead, fly on, or be pulled.
    for (const share of [0, 1]) {
      expect(inside(after.at, SIGHT + 0.3 + share * 6 * T, share * 3 * T)).toBeLessThan(1e-12);
      expect(inside(after.speed, share * 6, share * 3)).toBeLessThan(1e-12);
    }
    expect(inside(after.speed, 6 - CHASE * T, 3)).toBeLessThan(1e-3);
    expect(after.speed.within).toBeLessThan(4);
    const near = one(alien(100, 0, { v: [6, 3], blur: 0.5 }));
    expect(inside(near.speed, 6 - CHASE * T, 3)).toBeLessThan(-0.49);
    expect(near.speed.within).toBeLessThan(0.51);
    expect(near.at.within).toBeLessThan(0.5 * T + 1e-3);
  });

  it('one that moves in the least goes on even when she is out of its sight', () => {
    const cases = [
      { more: { v: [3, 0] }, at: [3, 0] },
      { more: { v: [0, -3] }, at: [0, -3] },
      { more: { blur: 0.5 }, at: [0, 0.5] },
    ] as const;
    for (const {
      more,
      at: [vx, vy],
    } of cases) {
      const after = one(alien(0, SIGHT + 20, more));
      for (const share of [0, 1]) expect(inside(after.at, share * vx * T, SIGHT + 20 + share * vy * T)).toBeLessThan(1e-12);
      expect(after.at.within).toBeGreaterThan(0);
    }
  });

  it('is drawn to wherever she may be, from wherever it may be, and no more strongly than aliens are', () => {
    // Most random doubles would be close to 0.
    const between = (min: number, max: number) => fc.nat(10_000).map((n) => min + ((max - min) * n) / 10_000);
    const angle = between(0, 2 * Math.PI);
    const share = between(0, 0.49);
    fc.assert(
      fc.property(angle, between(20, 110), share, share, fc.boolean(), (way, d, its, hers, left) => {
        const both = its + hers;
        // Both are moved to the side that turns its direction to her the most: across it.
        const across = way + Math.PI + (left ? 1 : -1) * (Math.PI / 2 + Math.asin(both));
        const e = { x: d * Math.cos(across), y: d * Math.sin(across) };
        const [x, y] = [d * Math.cos(way), d * Math.sin(way)];
        const half = { x: Math.abs(hers * e.x), y: Math.abs(hers * e.y) };
        const after = one(alien(x, y, { within: its * d }), area(-half.x, half.x, -half.y, half.y));
        expect(after.speed.within).toBeLessThan(CHASE * T + 1e-7);
        if (both < 0.49 && (1 + both) * d < SIGHT - 0.1) expect(after.speed.within).toBeLessThan((1.1 * both + 0.01) * CHASE * T);
        const [dx, dy] = [hers * e.x - (x - its * e.x), hers * e.y - (y - its * e.y)];
        const far = Math.hypot(dx, dy);
        if (far < 1) return;
        const pull = far < SIGHT ? (CHASE * T) / far : 0;
        // Meanwhile it moves by less than 0.02 px itself, and its direction turns by no more than that.
        expect(inside(after.speed, pull * dx, pull * dy)).toBeLessThan((0.02 / far) * CHASE * T);
      }),
      { numRuns: 1000 },
    );
  });

  it('one that she may be close to is drawn in any direction, and rounded outwards by 5e-8 px or px/s per step', () => {
    const { at: place, speed } = one(alien(3, 0, { within: 2 }), area(-1, 1, -1, 1));
    expect(Math.abs(speed.within - CHASE * T - 5e-8)).toBeLessThan(1e-8);
    expect(Math.abs(place.within - 2 - (CHASE * T * T) / 2 - 1e-7)).toBeLessThan(1e-8);
  });

  it('one that is this close may be pulled in any direction, and no more strongly than aliens are', () => {
    const after = one(alien(3, 0, { within: 2 }), area(-1, 1, -1, 1));
    for (const [x, y] of [
      [1, 0],
      [-1, 0],
      [0, 1],
      [0, -1],
    ]) {
      expect(inside(after.speed, x * CHASE * T * 0.999, y * CHASE * T * 0.999)).toBeLessThan(0);
    }
    expect(after.speed.within).toBeLessThan(CHASE * T + 1e-6);
  });

  const meet = (other: (d: number) => Chaser, truth: number, first = alien(0, 1000)): NearMiss => ({
    why: (d) => (afterChase(DEFAULT_RULES, [first, other(d)], here, T).every(({ isThere }) => isThere) ? null : 'may explode'),
    truth,
    safe: 'above',
    slack: [1e-7, 1e-6],
    says: 'may explode',
  });
  const pulled = (CHASE * T * T) / 2;
  nearMisses({
    'two that may touch explode': meet((d) => alien(d, 1000, { radius: 10 }), 35 + 2 * pulled),
    'wherever they may be': meet((d) => alien(0, 1000 - d, { within: 3 }), 50 + 3 + 2 * pulled),
    'however fast they may be': meet((d) => alien(0.6 * d, 1000 + 0.8 * d, { v: [3, 4], blur: 2 }), 50 + 7 * T + 2 * pulled),
    'whatever the first may do': meet(
      (d) => alien(0, 1000 + d),
      50 + 4 + 6 * T + 2 * pulled,
      alien(0, 1000, { within: 4, v: [0, -5], blur: 1 }),
    ),
  });

  it('one that may have exploded goes on as if it were there, and may explode another', () => {
    const perhaps = { ...alien(0, 1000), isThere: false };
    const [there] = afterChase(DEFAULT_RULES, [alien(0, 1000)], here, T);
    const [first, second] = afterChase(DEFAULT_RULES, [perhaps, alien(20, 1000)], here, T);
    expect(first).toEqual({ ...there, isThere: false });
    expect(second.isThere).toBe(false);
    expect(one(perhaps)).toEqual({ ...one(alien(0, 1000)), isThere: false });
  });

  it('is inside its disc in every play', () => {
    const play = fc.record({
      aliens: fc.array(fc.record({ x: fc.integer({ min: -220, max: 220 }), y: fc.integer({ min: -220, max: 220 }) }), {
        minLength: 1,
        maxLength: 2,
      }),
      v: fc.tuple(fc.integer({ min: -90, max: 90 }), fc.integer({ min: -90, max: 90 })),
      ticks: fc.constantFrom(1, 3, 6),
      holds: fc.array(fc.boolean(), { minLength: 30, maxLength: 30 }),
    });
    let awake = 0;
    fc.assert(
      fc.property(play, ({ aliens, v, ticks, holds }) => {
        const level = levelWith({
          astronaut: { ...ORIGIN, vx: v[0], vy: v[1] },
          asteroids: [at(60, -40)],
          aliens: aliens.map(({ x, y }) => at(x, y, 12)),
        });
        const run = createSimulation(compile(level, 'precise'));
        const state = new Float64Array(6);
        const places = new Float64Array(3 * aliens.length);
        let chasers: readonly Chaser[] = aliens.map(({ x, y }) => alien(x, y, { radius: 12 }));
        for (const held of holds) {
          const way = { left: Infinity, right: -Infinity, low: Infinity, high: -Infinity };
          const widen = () => {
            run.readState(state);
            const [x, y] = [state[0] - ORIGIN.x, state[1] - ORIGIN.y];
            // Her path bends by less than this within a tick.
            way.left = Math.min(way.left, x - 0.02);
            way.right = Math.max(way.right, x + 0.02);
            way.low = Math.min(way.low, y - 0.02);
            way.high = Math.max(way.high, y + 0.02);
          };
          widen();
          for (let n = 0; n < ticks; n++) {
            run.advance(1, held);
            widen();
          }
          if (run.ending !== null) return;
          run.readAliens(places);
          chasers = afterChase(DEFAULT_RULES, chasers, way, ticks / 60);
          for (const [i, { at: disc, isThere }] of chasers.entries()) {
            const [x, y, alive] = [places[3 * i] - ORIGIN.x, places[3 * i + 1] - ORIGIN.y, places[3 * i + 2]];
            if (alive === 0) expect(isThere).toBe(false);
            else expect(inside(disc, x, y)).toBeLessThan(1e-9);
            if (Math.hypot(x - aliens[i].x, y - aliens[i].y) > 1) awake++;
          }
        }
      }),
      { numRuns: 120 },
    );
    expectDeep(awake).toBeGreaterThan(100);
  });
});

describe('an alien that may be either of two', () => {
  it('is in a disc that contains both, and no larger than necessary', () => {
    const either = eitherChaser(alien(0, 0, { within: 2, v: [1, 0], blur: 0.5 }), alien(6, 8, { within: 1, v: [1, 5], blur: 0 }));
    expect(either.at.within).toBeCloseTo(6.5, 9);
    expect(either.at.centre.x).toBeCloseTo(0.6 * 4.5, 9);
    expect(either.at.centre.y).toBeCloseTo(0.8 * 4.5, 9);
    expect(either.speed.within).toBeCloseTo(2.75, 9);
    expect(either.speed.centre.y).toBeCloseTo(2.25, 9);
    expect(either.isThere).toBe(true);
  });

  it('contains both wherever they are, and extends no farther than it must', () => {
    const place = fc.record({
      x: fc.double({ min: -50, max: 50, noNaN: true }),
      y: fc.double({ min: -50, max: 50, noNaN: true }),
      within: fc.double({ min: 0, max: 40, noNaN: true }),
    });
    fc.assert(
      fc.property(place, place, (a, b) => {
        const either = eitherChaser(alien(a.x, a.y, a), alien(b.x, b.y, b)).at;
        const d = Math.hypot(b.x - a.x, b.y - a.y);
        for (const { x, y, within } of [a, b]) expect(inside(either, x, y) + within).toBeLessThan(2e-13);
        expect(either.within).toBeLessThan(Math.max(a.within, b.within, (a.within + b.within + d) / 2) + 1e-11);
      }),
      { numRuns: 400 },
    );
  });

  it('is the larger one if that contains the other', () => {
    const [small, large] = [alien(1, 1, { within: 1 }), alien(0, 0, { within: 2.5 })];
    expect(eitherChaser(small, large).at).toBe(large.at);
    expect(eitherChaser(large, small).at).toBe(large.at);
    const [beside, touching] = [alien(2, 0, { within: 1 }), alien(0, 0, { within: 2.5 })];
    expect(eitherChaser(beside, touching).at.within).toBeCloseTo(2.75, 9);
    expect(eitherChaser(touching, beside).at.within).toBeCloseTo(2.75, 9);
  });

  it('is not certainly there if one of them may be gone', () => {
    const gone = { ...alien(0, 0), isThere: false };
    expect(eitherChaser(gone, alien(1, 0)).isThere).toBe(false);
    expect(eitherChaser(alien(1, 0), gone).isThere).toBe(false);
  });
});
