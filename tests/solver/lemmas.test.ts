import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type AccuracyName, boxCircleGap, boxOf, compile, createSimulation, simulate, TICK } from '../../engine/index.ts';
import { DEFAULT_RULES, type Disc, type Hold, type Level, NO_OBJECTS, type OwnRules, rulesOf } from '../../schema/index.ts';
import { afterChase, type Chaser } from '../../solver/verify/chasers.ts';
import { claimOf, mouthsOf, type Play } from '../../solver/verify/claim.ts';
import {
  accelerations,
  advance,
  placesWithin,
  type Rectangle,
  type StateBox,
  withPlacesBefore,
} from '../../solver/verify/doomed.ts';
import { offLine } from '../../solver/verify/fall.ts';
import { turnedScene } from '../../solver/verify/turned-scene.ts';
import { expectDeep } from '../depth.ts';
import { continuousNames } from '../engine/accuracies.ts';
import { accuracyNames } from '../levels/shipped-pack.ts';
import { real } from '../real.ts';
import { windyLevel } from './proofs-crowded.ts';
import { someRules } from './some-rules.ts';

// The lemmas of docs/proofs.md, each by its name, compared with the engine at every accuracy that a proof resting on it covers,
// under any rules that a level may have.

const PLAYS: Readonly<Record<AccuracyName, Play>> = { arcade: 'frames', fast: 'steps', standard: 'steps', precise: 'exact' };
const HOLE = { kind: 'blackHole' } as const;

const whole = (min: number, max: number) => fc.integer({ min, max });
// Evenly distributed, unlike the doubles of fast-check.

const EMPTY: Level = {
  name: 'lemma',
  description: '',
  astronaut: { x: 0, y: 0, vx: 0, vy: 0 },
  blackHole: { x: 0, y: 1e7, radius: 18 },
  range: 250,
  recoil: false,
  ...NO_OBJECTS,
  // Objects that she never comes near change nothing.
  winds: [{ id: null, x: 0, y: -9000, radius: 60, ax: 3, ay: -20 }],
  wormholes: [{ id: null, x: 0, y: -9000, toX: 500, toY: -9000, radius: 20 }],
  runs: [],
};
const rock = (x: number, y: number, radius: number) => ({ id: null, x, y, radius, hot: false });

/**
 * A sequence of ticks: held or free, each for so many ticks. `pump` holds while she approaches the first asteroid, `brake`
 * while she moves away.
 */
const script = fc.array(fc.tuple(whole(1, 60), fc.constantFrom('held', 'free', 'pump', 'pump')), { minLength: 5, maxLength: 40 });
type Script = readonly (readonly [number, string])[];

/** Long enough to pass the centre many times, fast and slowly. */
const longScript = fc.array(fc.tuple(whole(1, 90), fc.constantFrom('held', 'free', 'pump', 'pump')), {
  minLength: 40,
  maxLength: 60,
});

/** Her state at each tick while the run goes on: x, y, vx, vy, cos, sin; and whether the gun was held in the next tick. */
function statesOf(level: Level, accuracy: AccuracyName, plan: Script) {
  const simulation = createSimulation(compile(level, accuracy));
  const state = new Float64Array(6);
  const rocks = new Float64Array(2 * level.asteroids.length);
  const all: { s: number[]; rocks: number[] }[] = [];
  const holds: Hold[] = [];
  const look = () => {
    simulation.readState(state);
    simulation.readAsteroids(rocks);
    all.push({ s: [...state], rocks: [...rocks] });
  };
  look();
  for (const [ticks, how] of plan) {
    for (let n = 0; n < ticks && simulation.ending === null; n++) {
      const [x, y, vx, vy] = state;
      const nearer = (rocks[0] - x) * vx + (rocks[1] - y) * vy >= 0;
      const held = how === 'held' || (how === 'pump' && nearer) || (how === 'brake' && !nearer);
      if (held) holds.push([simulation.tick, simulation.tick + 1]);
      simulation.advance(1, held);
      if (simulation.ending === null) look();
    }
  }
  return { all, holds, seconds: all.length * TICK };
}

describe('reach: how near a box must be to touch for certain, and how near to touch at all', () => {
  it('half its shorter side for certain, half its diagonal at most, at any angle', () => {
    let farthest = 0;
    fc.assert(
      fc.property(someRules, real(0, 2), real(0, 6.3), real(0, 6.3), real(0.001, 100), (rules, part, to, turn, radius) => {
        const box = boxOf(rulesOf({ rules }));
        const { touch, inner, thing } = claimOf({ ...EMPTY, rules }, HOLE, 60, 'exact');
        const gap = part * box.halfDiagonal;
        const d = radius + gap;
        const g = boxCircleGap(box, d * Math.cos(to), d * Math.sin(to), Math.cos(turn), Math.sin(turn), radius);
        if (gap < inner - 1e-9) expect(g).toBeLessThan(0);
        if (gap >= touch - thing.radius) expect(g).toBeGreaterThanOrEqual(0);
        if (g < 0) farthest = Math.max(farthest, part);
      }),
      { numRuns: 1000 },
    );
    expectDeep(farthest).toBeGreaterThan(0.95);
  });
});

/** Whether an axis of her velocity may reach the speed limit, where proofs end. */
function comesToLimit(level: Level, all: readonly { s: readonly number[] }[]): boolean {
  const { pull, push, speedLimit } = rulesOf(level);
  const most = 0.99 * speedLimit - Math.max(pull, push) * TICK;
  return all.some(({ s }) => Math.max(Math.abs(s[2]), Math.abs(s[3])) > most);
}

/** Whether her box at the start touches a mineral of 7 px. */
function isTouchedAtStart(rules: OwnRules, x: number, y: number): boolean {
  return boxCircleGap(boxOf(rulesOf({ rules })), x, y, 1, 0, 7) < 0.1;
}

describe('line: from rest in front of one asteroid she stays on the line through it, and her box lies along it', () => {
  it.each(continuousNames)('%s', (accuracy) => {
    let passes = 0;
    fc.assert(
      fc.property(
        someRules,
        real(50, 150),
        real(0, 6.3),
        fc.constantFrom(0, 0, 0.5, 16),
        longScript,
        (rules, d, turn, recoil, plan) => {
          const { halfHeight } = boxOf(rulesOf({ rules }));
          const [ux, uy] = [Math.cos(turn), Math.sin(turn)];
          // As near beside the centre as a box that flips there allows; one that sweeps around would touch them.
          const beside =
            recoil > 0
              ? []
              : [-8, -7.01, 7.01, 9]
                  .map((more) => more + Math.sign(more) * halfHeight)
                  .map((far) => ({ x: d * ux - far * uy, y: d * uy + far * ux }));
          const minerals = beside.map((place) => ({ id: null, ...place, radius: 7 }));
          const upright = minerals.filter(({ x, y }) => !isTouchedAtStart(rules, x, y));
          const level = {
            ...EMPTY,
            rules,
            recoil: recoil > 0,
            asteroids: [rock(d * ux, d * uy, recoil || 16)],
            minerals: upright,
          };
          const { holds, seconds, all } = statesOf(level, accuracy, plan);
          if (comesToLimit(level, all)) return;
          for (let i = 1; i < all.length; i++) {
            const side = ({ s, rocks }: (typeof all)[number]) => (rocks[0] - s[0]) * ux + (rocks[1] - s[1]) * uy > 0;
            if (side(all[i - 1]) !== side(all[i])) passes++;
          }
          const run = simulate(compile(level, accuracy), holds, { maxTime: seconds });
          expect(run.minerals).toEqual([]);
          const state = new Float64Array(6);
          const first = (holds[0]?.[0] ?? Number.POSITIVE_INFINITY) * TICK;
          for (let k = 0; k <= 200; k++) {
            const time = (Math.min(run.time, seconds) * k) / 200;
            run.trajectory.at(time, state);
            const [x, y, , , cos, sin] = state;
            if (Math.abs(y * ux - x * uy) > 1e-9) expect.fail(`${Math.abs(y * ux - x * uy)} px off the line at ${time} s`);
            const askew = time >= first ? Math.abs(sin * ux - cos * uy) : Math.abs(sin);
            if (askew > 1e-9) expect.fail(`askew by ${askew} at ${time} s`);
          }
        },
      ),
      { numRuns: 40 },
    );
    expectDeep(passes).toBeGreaterThan(12);
  });
});

describe('speed on a line: no faster than from rest at the far end to the centre', () => {
  it.each(continuousNames)('%s', (accuracy) => {
    let closest = 0;
    fc.assert(
      fc.property(someRules, real(20, 245), real(0, 6.3), script, (rules, d, turn, plan) => {
        const level = { ...EMPTY, rules, asteroids: [rock(d * Math.cos(turn), d * Math.sin(turn), 16)] };
        const most = Math.sqrt(2 * rulesOf(level).pull * (250 - 125));
        for (const { s } of statesOf(level, accuracy, plan).all) {
          const v = Math.hypot(s[2], s[3]);
          if (v > 1.001 * most) expect.fail(`${v} px/s of ${most}`);
          closest = Math.max(closest, v / most);
        }
      }),
      { numRuns: 30 },
    );
    expectDeep(closest).toBeGreaterThan(0.7);
  });
});

describe('speed: v² is at most v0² plus twice the strongest push times the distance', () => {
  it.each(accuracyNames)('%s', (accuracy) => {
    fc.assert(
      fc.property(windyLevel, someRules, script, (of, rules, plan) => {
        // Through wormholes she falls the same distance again.
        const level = { ...of, wormholes: [], rules };
        const { push } = claimOf(level, HOLE, 60, PLAYS[accuracy]);
        const { all } = statesOf(level, accuracy, plan);
        const start = level.astronaut.vx ** 2 + level.astronaut.vy ** 2;
        const low = [0, 0];
        const high = [0, 0];
        for (const { s } of all) {
          for (const axis of [0, 1]) {
            low[axis] = Math.min(low[axis], s[axis]);
            high[axis] = Math.max(high[axis], s[axis]);
          }
          const way = Math.hypot(high[0] - low[0], high[1] - low[1]);
          // What a tick gains, because observations are a tick apart.
          expect(Math.hypot(s[2], s[3])).toBeLessThanOrEqual(1.0005 * Math.sqrt(start + 2 * push * way) + 2 * push * TICK);
        }
      }),
      { numRuns: 30 },
    );
  });
});

describe('jump: a frame takes her no farther than the claim says', () => {
  it('arcade', () => {
    let closest = 0;
    fc.assert(
      fc.property(windyLevel, someRules, fc.constantFrom(1, 1, 12), script, (of, rules, faster, plan) => {
        const { vx, vy } = of.astronaut;
        const level = { ...of, rules, astronaut: { ...of.astronaut, vx: faster * vx, vy: faster * vy } };
        const { jump } = claimOf(level, HOLE, 60, 'frames');
        const { all } = statesOf(level, 'arcade', plan);
        for (let i = 1; i < all.length; i++) {
          const moved = { x: all[i].s[0] - all[i - 1].s[0], y: all[i].s[1] - all[i - 1].s[1] };
          const ways = [moved, ...shiftsOf(level).map(({ x, y }) => ({ x: moved.x - x, y: moved.y - y }))];
          const way = Math.min(...ways.map(({ x, y }) => Math.hypot(x, y)));
          if (way > jump) expect.fail(`${way} px of ${jump}`);
          closest = Math.max(closest, way / jump);
        }
      }),
      { numRuns: 50 },
    );
    expectDeep(closest).toBeGreaterThan(0.9);
  });
});

describe('drift: recoil carries an asteroid no farther than the claim says', () => {
  it.each(accuracyNames)('%s', (accuracy) => {
    let closest = 0;
    fc.assert(
      fc.property(
        someRules,
        real(20, 240),
        fc.constantFrom(0.05, 1, 16),
        whole(1, 200),
        script,
        (rules, d, radius, first, plan) => {
          const level = { ...EMPTY, rules, recoil: true, asteroids: [rock(d, 0, radius)] };
          const { all } = statesOf(level, accuracy, [[first, 'held'], ...plan]);
          for (const [tick, { rocks }] of all.entries()) {
            if (tick === 0) continue;
            const most = claimOf(level, HOLE, tick * TICK, PLAYS[accuracy]).drift(0);
            const far = Math.hypot(rocks[0] - d, rocks[1]);
            if (far > most + 1e-9) expect.fail(`${far} px of ${most} after ${tick} ticks`);
            if (most > 0) closest = Math.max(closest, far / most);
          }
        },
      ),
      { numRuns: 30 },
    );
    expectDeep(closest).toBeGreaterThan(0.9);
  });
});

describe('arcade-axis: on a line along an axis everything across is exactly 0', () => {
  it.each([
    ['x', 1, 0],
    ['-x', -1, 0],
    ['y, up to the centre', 0, 1],
    ['-y, up to the centre', 0, -1],
  ])('%s', (_, ux, uy) => {
    let passes = 0;
    fc.assert(
      fc.property(
        fc.oneof(whole(20, 240), real(20, 240)),
        real(-1e4, 1e4),
        real(-1e4, 1e4),
        fc.boolean(),
        someRules,
        script,
        (d, x, y, recoil, rules, plan) => {
          const level = {
            ...EMPTY,
            rules,
            recoil,
            astronaut: { x, y, vx: 0, vy: 0 },
            asteroids: [rock(x + d * ux, y + d * uy, 16)],
          };
          const { all } = statesOf(level, 'arcade', plan);
          for (const { s, rocks } of all) {
            const before = (rocks[0] - s[0]) * ux + (rocks[1] - s[1]) * uy > 0;
            if (!before) passes++;
            // At the very centre the original pulls to the right.
            if (!before && uy !== 0) return;
            const across = ux === 0 ? 0 : 1;
            if (s[across] !== (across === 0 ? x : y) || s[2 + across] !== 0) expect.fail(`across: ${s}`);
          }
        },
      ),
      { numRuns: 30 },
    );
    expectDeep(passes).toBeGreaterThan(10);
  });
});

describe('arcade-fall: on the way to the centre rounding takes her no farther off the line than the bound', () => {
  it('arcade', () => {
    let looks = 0;
    let largest = 0;
    fc.assert(
      fc.property(
        someRules,
        real(40, 240),
        real(0.1, 1.4),
        real(-2000, 2000),
        fc.boolean(),
        script,
        (rules, d, turn, x, recoil, plan) => {
          const [ux, uy] = [Math.cos(turn), Math.sin(turn)];
          const level = {
            ...EMPTY,
            rules,
            recoil,
            astronaut: { x, y: -x, vx: 0, vy: 0 },
            asteroids: [rock(x + d * ux, -x + d * uy, 16)],
          };
          const { all } = statesOf(level, 'arcade', plan);
          const [centre] = [all[0].rocks];
          // The line through the two places as they are.
          const [lx, ly] = [centre[0] - x, centre[1] + x];
          const length = Math.hypot(lx, ly);
          const { pull, recoil: strength, speedLimit } = rulesOf(level);
          const kick = recoil ? strength / 32 : 0;
          const speed = 1.01 * Math.sqrt(2 * pull * length) + 1;
          const rockSpeed = 1.01 * Math.sqrt(2 * kick * length) + kick * TICK;
          // The speed limit of one axis would take either of them off the line.
          if (Math.max(speed, rockSpeed) > 0.99 * speedLimit) return;
          const jump = speed * TICK;
          const nearest = 1 + 2 * (jump + rockSpeed * TICK);
          const bound = offLine({
            centre: length,
            nearest,
            jump,
            coordinate: 2 * Math.abs(x) + length,
            push: Math.max(pull, kick),
            speed,
            seconds: 60,
            rockSpeed,
            drift: recoil ? length : 0,
          });
          for (const { s, rocks } of all) {
            const [rx, ry] = [s[0] - x, s[1] + x];
            if ((rocks[0] - s[0]) * lx + (rocks[1] - s[1]) * ly < nearest * length) return;
            looks++;
            const beside = Math.abs(ry * lx - rx * ly) / length;
            largest = Math.max(largest, beside / bound.beside);
            if (beside > bound.beside) expect.fail(`${beside} px of ${bound.beside}`);
          }
        },
      ),
      { numRuns: 40 },
    );
    expectDeep(looks).toBeGreaterThan(2000);
    expectDeep(largest).toBeGreaterThan(1e-12);
  });
});

/** Whether a disc overlaps a rectangle, or nearly so. */
const isNear = ({ x, y, radius }: Disc, way: Rectangle): boolean =>
  Math.hypot(Math.max(0, way.x[0] - x, x - way.x[1]), Math.max(0, way.y[0] - y, y - way.y[1])) < radius + 1e-6;

/** The displacement of each wormhole, in either direction. */
const shiftsOf = ({ wormholes }: Level): { x: number; y: number }[] =>
  wormholes.flatMap(({ x, y, toX, toY }) => [
    { x: toX - x, y: toY - y },
    { x: x - toX, y: y - toY },
  ]);

describe('mouths: only a mouth moves her, from inside it by the displacement to the other', () => {
  it.each(accuracyNames)('%s', (accuracy) => {
    let jumps = 0;
    fc.assert(
      fc.property(windyLevel, someRules, real(26, 60), real(0, 6.3), script, (of, rules, far, turn, plan) => {
        const near = { id: null, x: far * Math.cos(turn), y: far * Math.sin(turn), toX: -100, toY: 60, radius: 24 };
        const level = { ...of, rules, wormholes: [near, ...of.wormholes], novae: [], aliens: [] };
        const { jump } = claimOf(level, HOLE, 60, PLAYS[accuracy]);
        const { speedLimit } = rulesOf(level);
        const { all } = statesOf(level, accuracy, plan);
        // In continuous time an observation comes after a tick in which she moves on; at the limit a fixed step may overshoot.
        const room = accuracy === 'arcade' ? jump : 1.5 * Math.SQRT2 * speedLimit * TICK;
        for (let i = 1; i < all.length; i++) {
          const [before, after] = [all[i - 1].s, all[i].s];
          if (Math.hypot(after[0] - before[0], after[1] - before[1]) <= room) continue;
          const taken = mouthsOf(claimOf(level, HOLE, 60, PLAYS[accuracy])).filter(
            ({ x, y, radius }) => Math.hypot(before[0] - x, before[1] - y) < radius + (accuracy === 'arcade' ? 0 : room),
          );
          jumps++;
          const comesOut = all[i].s;
          const ends = taken.some(({ radius, exit }) => Math.hypot(comesOut[0] - exit.x, comesOut[1] - exit.y) < radius + room);
          // In continuous time, several in one tick lead from exit to exit.
          if (!ends && (accuracy === 'arcade' || level.wormholes.length === 1)) expect.fail(`${before} to ${after}`);
        }
      }),
      { numRuns: 100 },
    );
    expectDeep(jumps).toBeGreaterThan(3);
  });
});

/**
 * Levels in which little is left to chance: she is in a wind all the time, and recoil is as strong as she is pulled or stronger,
 * so that what a method adds or leaves out shows.
 */
const blownLevel: fc.Arbitrary<Level> = fc
  .record({
    speed: fc.tuple(whole(-60, 60), whole(-60, 60)),
    wind: fc.tuple(whole(-100, 100), whole(-100, 100)),
    place: fc.tuple(real(-150, 150), real(-150, 150)),
    radius: fc.constantFrom(0.05, 0.5, 16),
    recoil: fc.boolean(),
  })
  .map(({ speed: [vx, vy], wind: [ax, ay], place: [x, y], radius, recoil }) => ({
    ...EMPTY,
    recoil,
    astronaut: { x: 0, y: 0, vx, vy },
    asteroids: [rock(x, y, radius)],
    winds: [{ id: null, x: 0, y: 0, radius: 2000, ax, ay }],
  }));

describe('pushes: after some ticks her state is within what the pushes at the places on the way allow', () => {
  it.each(accuracyNames)('%s', (accuracy) => {
    let steps = 0;
    fc.assert(
      fc.property(fc.oneof(windyLevel, blownLevel), someRules, script, whole(2, 8), (of, rules, plan, frames) => {
        const level = { ...of, rules };
        const { speedLimit } = rulesOf(level);
        const claim = claimOf(level, HOLE, 60, PLAYS[accuracy]);
        const scene = turnedScene(claim, [1, 0]);
        const { all } = statesOf(level, accuracy, plan);
        const seconds = frames * TICK;
        // A frame moves by a velocity that has the push of the frame before.
        const lag = accuracy === 'arcade' ? TICK : 0;
        const push = claim.push + claim.blur;
        const about = (n: number) => [n - 1e-7, n + 1e-7] as const;
        for (let i = 0; i + frames < all.length; i += frames) {
          const [x, y, vx, vy] = all[i].s;
          // At the speed limit there is no proof.
          if (Math.hypot(vx, vy) + push * (seconds + TICK) > speedLimit) break;
          const box: StateBox = { x: about(x), y: about(y), vx: about(vx), vy: about(vy) };
          const way = placesWithin(box, seconds, push);
          if (scene.mouths.some((mouth) => isNear(mouth, way))) continue;
          // Nothing has pushed her before the start.
          const pushed = i === 0 ? way : withPlacesBefore(way, box, lag);
          const [ax, ay] = accelerations(claim, scene, pushed, (i + frames) * TICK);
          const after = advance(box, ax, ay, seconds, i === 0 ? lag : 0);
          const to = all[i + frames].s;
          steps++;
          for (const [n, key] of (['x', 'y', 'vx', 'vy'] as const).entries()) {
            if (to[n] < after[key][0] || to[n] > after[key][1]) expect.fail(`${key} ${to[n]} is not in ${after[key]}`);
          }
          for (let k = i; k <= i + frames; k++) {
            const [x, y] = all[k].s;
            if (x < way.x[0] || x > way.x[1] || y < way.y[0] || y > way.y[1]) expect.fail(`${x} ${y} is not on the way`);
          }
        }
      }),
      { numRuns: 80 },
    );
    expectDeep(steps).toBeGreaterThan(300);
  });
});

describe('chasers: aliens are within their discs, and those claimed to be there have not exploded', () => {
  const swarm = fc.array(fc.tuple(whole(-170, 170), whole(-170, 170), fc.constantFrom(4, 12, 25)), {
    minLength: 2,
    maxLength: 6,
  });

  it.each(continuousNames)('%s', (accuracy) => {
    let certain = 0;
    let gone = 0;
    fc.assert(
      fc.property(swarm, someRules, whole(-40, 40), script, (places, rules, vy, plan) => {
        const level: Level = {
          ...EMPTY,
          rules,
          astronaut: { x: 0, y: 0, vx: 30, vy },
          asteroids: [rock(60, 60, 16)],
          aliens: places.map(([x, y, radius]) => ({ id: null, x, y, radius })),
        };
        const simulation = createSimulation(compile(level, accuracy));
        const aliens = new Float64Array(3 * places.length);
        const s = new Float64Array(6);
        let chasers: readonly Chaser[] = places.map(([x, y, radius]) => ({
          at: { centre: { x, y }, within: 0 },
          speed: { centre: { x: 0, y: 0 }, within: 0 },
          radius,
          isThere: true,
        }));
        for (const [ticks, how] of plan) {
          for (let n = 0; n < ticks && simulation.ending === null; n++) {
            simulation.readState(s);
            const before = [...s];
            simulation.advance(1, how === 'held');
            if (simulation.ending !== null) return;
            simulation.readState(s);
            const bend = 0.02 + claimOf(level, HOLE, 60, PLAYS[accuracy]).push * TICK * TICK;
            const area = {
              left: Math.min(before[0], s[0]) - bend,
              right: Math.max(before[0], s[0]) + bend,
              low: Math.min(before[1], s[1]) - bend,
              high: Math.max(before[1], s[1]) + bend,
            };
            chasers = afterChase(rulesOf(level), chasers, area, TICK);
            simulation.readAliens(aliens);
            for (const [i, { at, isThere }] of chasers.entries()) {
              const there = aliens[3 * i + 2] === 1;
              if (!there) gone++;
              if (isThere) {
                certain++;
                if (!there) expect.fail(`alien ${i} has exploded`);
              }
              const off = Math.hypot(aliens[3 * i] - at.centre.x, aliens[3 * i + 1] - at.centre.y);
              if (there && off > at.within + 1e-7) expect.fail(`alien ${i}: ${off} px of ${at.within}`);
            }
          }
        }
      }),
      { numRuns: 25 },
    );
    expectDeep(certain).toBeGreaterThan(300);
    expectDeep(gone).toBeGreaterThan(30);
  });

  it('an alien that may have exploded may still explode others', () => {
    const alien = (x: number): Chaser => ({
      at: { centre: { x, y: 0 }, within: 1 },
      speed: { centre: { x: 0, y: 0 }, within: 1 },
      radius: 10,
      isThere: true,
    });
    const away = { left: 900, right: 901, low: 0, high: 1 };
    const [a, b, c] = afterChase(DEFAULT_RULES, [alien(0), alien(21), alien(26 + 20)], away, TICK);
    expect([a.isThere, b.isThere, c.isThere]).toEqual([false, false, true]);
    // b moves towards c.
    const nearer = [a, { ...b, at: { ...b.at, centre: { x: 26, y: 0 } } }, c];
    expect(afterChase(DEFAULT_RULES, nearer, away, TICK)[2].isThere).toBe(false);
  });
});

describe('order: she leaves a mouth onto a hazard and the black hole', () => {
  it.each(continuousNames)('%s: collides', (accuracy) => {
    fc.assert(
      fc.property(real(-12, 12), real(-20, 20), real(2, 60), fc.boolean(), (dx, dy, v, hot) => {
        const there = { id: null, x: 150 + dx, y: 40 + dy, radius: 18 };
        const level: Level = {
          ...EMPTY,
          astronaut: { x: 0, y: 0, vx: v, vy: 0 },
          asteroids: [rock(0, 120, 16), ...(hot ? [{ ...rock(there.x, there.y, 18), hot: true }] : [])],
          novae: hot ? [] : [there],
          blackHole: { x: 150 - dx, y: 40 - dy, radius: 18 },
          wormholes: [{ id: null, x: 30, y: 0, toX: 154, toY: 40, radius: 5 }],
        };
        const run = simulate(compile(level, accuracy), []);
        // Possibly only one of them is touched there.
        const touches = (c: { x: number; y: number }) => boxCircleGap(boxOf(rulesOf(level)), c.x - 149, c.y - 40, 1, 0, 18) < 0;
        if (touches(there)) expect(run.outcome).toBe('collided');
      }),
      { numRuns: 30 },
    );
  });
});

describe('order: a hazard and the black hole at the same instant', () => {
  it.each(accuracyNames)('%s', (accuracy) => {
    // Her upright box comes down on both at once.
    const level = {
      ...EMPTY,
      astronaut: { x: 0, y: 0, vx: 0, vy: 30 },
      asteroids: [rock(0, 200, 16)],
      blackHole: { id: null, x: 5, y: 60, radius: 18 },
      novae: [{ id: null, x: -5, y: 60, radius: 18 }],
    };
    expect(simulate(compile(level, accuracy), []).outcome).toBe(accuracy === 'arcade' ? 'completed' : 'collided');
  });
});
