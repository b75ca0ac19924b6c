import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  type AccuracyName,
  boxCircleGap,
  compile,
  createSimulation,
  DEFAULT_BOX,
  type Run,
  STATE_SIZE,
  simulate,
  WorkBudget,
} from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { describeQuick, itQuick } from '../depth.ts';
import { continuousNames } from '../engine/accuracies.ts';
import { type PlainLevel, plainLevel } from '../engine/plain-level.ts';
import { once } from '../once.ts';
import { real } from '../real.ts';
import { bounceByBounce } from './bounce.ts';
import { slideByAngle as computeSlide, type Slid } from './slide-by-angle.ts';

// Every accuracy is compared with the same slides.
const slideByAngle = once(computeSlide);

/** s; the allowed error of the time at which she leaves the rim */
const OFF = { precise: 1e-9, standard: 1e-6, fast: 1e-3 };
const HELD: Hold[] = [[0, 3600]];
const TIMES = Array.from({ length: 12 }, (_, i) => (i + 1) / 12);

/** She starts on the rim of a field of 48 px, which is between her start and the asteroid. */
const onRim = (parts: PlainLevel = {}): Level =>
  plainLevel({
    range: 250,
    astronaut: { x: -48, y: 0 },
    asteroids: [{ x: 70, y: 11, radius: 16 }],
    repulsors: [{ x: 0, y: 0, radius: 48 }],
    ...parts,
  });

const play = (level: Level, accuracy: AccuracyName, holds: readonly Hold[], maxTime: number): Run =>
  simulate(compile(level, accuracy), holds, { maxTime });

function placeAt(run: Run, time: number): Float64Array {
  const state = new Float64Array(STATE_SIZE);
  run.trajectory.at(time, state);
  return state;
}

const away = (run: Run, { time, x, y }: Slid): number => Math.hypot(placeAt(run, time)[0] - x, placeAt(run, time)[1] - y);

const leaves = (run: Run): number | undefined => run.events.find((e) => e.type === 'leave')?.time;

const STARTS: readonly (readonly [string, Level])[] = [
  ['from rest', onRim()],
  ['from rest in a slanted place', onRim({ astronaut: { x: -28.8, y: 38.4 } })],
  ['with a speed along the rim', onRim({ astronaut: { x: -48, y: 0, vy: 12 } })],
  ['with one against the pull', onRim({ astronaut: { x: -48, y: 0, vy: -9 } })],
  ['drawing the asteroid near', onRim({ recoil: true, asteroids: [{ x: 70, y: 11, radius: 0.2 }] })],
  [
    'far from the origin',
    onRim({
      astronaut: { x: 4096 - 48, y: 2 ** 14 },
      asteroids: [{ x: 4166, y: 2 ** 14 + 11, radius: 16 }],
      repulsors: [{ x: 4096, y: 2 ** 14, radius: 48 }],
    }),
  ],
  [
    'along a rim of 10,000 px',
    onRim({
      range: 2e4,
      astronaut: { x: -1e4, y: 0, vy: 100 },
      asteroids: [{ x: -9000, y: 5000, radius: 16 }],
      repulsors: [{ x: 0, y: 0, radius: 1e4 }],
    }),
  ],
];

const BOUNCES = [
  [2e-3, 0],
  [-2.4e-3, 5],
  [3e-4, -4],
].map(([across, along]) => {
  const level = onRim({ astronaut: { x: -48, y: 0, vx: -across, vy: along } });
  const times = [0.1, 0.25, 0.4];
  return { across, along, level, times, states: bounceByBounce(level, times) };
});

describe.each(continuousNames)('bounces lower than 1e-6 px count as sliding: %s', (accuracy) => {
  it.each(BOUNCES)('$across px/s across the rim, $along px/s along it', ({ level, times, states }) => {
    const run = play(level, accuracy, HELD, 0.5);
    for (const [i, [x, y, vx, vy]] of states.entries()) {
      const state = placeAt(run, times[i]);
      expect(Math.hypot(state[0] - x, state[1] - y)).toBeLessThan(1e-6);
      expect(Math.hypot(state[2] - vx, state[3] - vy)).toBeLessThan(1e-2);
    }
    expect(run.work.pieces).toBeLessThan(100);
  });
});

/** By the angle, in small steps: at the limit along y until the forces would push her back along it. */
const slideAtLimit = once((level: Level, seconds: number): [x: number, y: number, vy: number] => {
  const { radius } = level.repulsors[0];
  const [target] = level.asteroids;
  const h = 1e-4;
  let angle = Math.atan2(level.astronaut.y, level.astronaut.x);
  let turn = (level.astronaut.vy * Math.cos(angle) - level.astronaut.vx * Math.sin(angle)) / radius;
  // the acceleration of the angle without the limit
  const bends = (angle: number, turn: number) => {
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const [wx, wy] = [target.x - radius * c, target.y - radius * s];
    const f = 39 * (1 / Math.hypot(wx, wy) - 1 / level.range);
    const out = f * (wx * c + wy * s);
    const share = (20 + radius * turn * turn) / (20 - out);
    return (share * f * (wy * c - wx * s)) / radius;
  };
  for (let n = 0; n < seconds / h - 0.5; n++) {
    const along = bends(angle, turn);
    const middle = bends(angle + (turn * h) / 2, turn + (along * h) / 2);
    angle += turn * h + (along * h * h) / 2;
    turn += middle * h;
    const limit = 1000 / (radius * Math.abs(Math.cos(angle)));
    if (Math.abs(turn) > limit) turn = Math.sign(turn) * limit;
  }
  return [radius * Math.cos(angle), radius * Math.sin(angle), radius * turn * Math.cos(angle)];
});

describeQuick.each(continuousNames)('sliding on a rim at the speed limit: %s', (accuracy) => {
  it('the limit holds her until the forces would push her back', () => {
    const radius = 5e4;
    for (const sign of [1, -1]) {
      const level = onRim({
        range: 1e6,
        astronaut: { x: -radius, y: 0, vy: sign * 990 },
        asteroids: [{ x: -radius + 2000, y: sign * 3000, radius: 16 }],
        repulsors: [{ x: 0, y: 0, radius }],
      });
      const run = play(level, accuracy, HELD, 6);
      let reached = false;
      for (let time = 0.5; time <= 6; time += 0.5) {
        const [x, y, vy] = slideAtLimit(level, time);
        const state = placeAt(run, time);
        expect(Math.hypot(state[0] - x, state[1] - y)).toBeLessThan(0.02);
        expect(Math.abs(state[3] - vy)).toBeLessThan(0.02);
        reached ||= Math.abs(state[3]) === 1000;
      }
      expect(reached).toBe(true);
      expect(Math.abs(placeAt(run, 6)[3])).toBeLessThan(990);
    }
  });
});

describe.each(continuousNames)('sliding on a rim, against the equation of the angle: %s', (accuracy) => {
  it.each(STARTS)('%s', (_, level) => {
    const run = play(level, accuracy, HELD, 10);
    const whole = slideByAngle(level, 10);
    expect(run.events.filter((e) => e.type === 'enter')).toHaveLength(1);
    for (const part of TIMES) {
      const slid = slideByAngle(level, whole.time * part);
      // the target moves in the steps of `fast`
      expect(away(run, slid)).toBeLessThan(accuracy === 'fast' && level.recoil ? 0.1 : 1e-9);
      const rocks = new Float64Array(2);
      run.trajectory.asteroidsAt(slid.time, rocks);
      if (accuracy === 'precise') expect(Math.hypot(rocks[0] - slid.rock[0], rocks[1] - slid.rock[1])).toBeLessThan(1e-9);
    }
    if (whole.off) expect(Math.abs((leaves(run) ?? Number.NaN) - whole.time)).toBeLessThan(OFF[accuracy]);
    else expect(leaves(run)).toBeUndefined();
  });

  it('holds for any start on a rim, any size of the rim and any place of the asteroid', () => {
    fc.assert(
      fc.property(
        real(0, 2 * Math.PI),
        real(5, 500),
        real(-150, 150),
        real(-150, 150),
        real(-0.9, 0.9),
        (angle, radius, x, y, share) => {
          const [c, s] = [Math.cos(angle), Math.sin(angle)];
          const at = { x: 3 + radius * c, y: -2 + radius * s };
          const asteroid = { x: at.x + x, y: at.y + y, radius: 16 };
          const pull = -39 * (1 / Math.hypot(x, y) - 1 / 250) * (x * c + y * s);
          fc.pre(pull > 2);
          // a share of the speed at which she would leave the rim
          const v = share * Math.sqrt(pull * radius);
          const level = onRim({
            astronaut: { ...at, vx: -v * s, vy: v * c },
            asteroids: [asteroid],
            repulsors: [{ x: 3, y: -2, radius }],
          });
          const whole = slideByAngle(level, 2, 'gun', 2e-3);
          const run = play(level, accuracy, HELD, 2);
          // the reference also has errors if the asteroid is close to the rim
          for (const part of [0.3, 0.6, 0.9])
            expect(away(run, slideByAngle(level, part * whole.time, 'gun', 1e-3))).toBeLessThan(1e-8);
        },
      ),
      { numRuns: 20 },
    );
  });

  // nearly on a circle about the centre of the pull, the holding force hardly varies, and only just reaches 0
  itQuick('ends correctly after the holding force has been close to 0 for a long time', () => {
    let off = 0;
    for (const rest of [3e-2, 1e-3, 1e-5]) {
      for (const aside of [1e-3, 0.03, 0.4]) {
        const radius = 100;
        const pull = 39 * (1 - radius / 250);
        const level = onRim({
          astronaut: { x: -radius, y: 0, vy: Math.sqrt(radius * (pull - rest)) },
          asteroids: [{ x: 0, y: -aside, radius: 16 }],
          repulsors: [{ x: 0, y: 0, radius }],
        });
        const slid = slideByAngle(level, 20, 'gun', 1e-3);
        const run = play(level, accuracy, HELD, 20);
        // where nothing holds her at first she is outside at once
        if (!slid.off || slid.time === 0) continue;
        off++;
        expect(Math.abs((leaves(run) ?? Number.NaN) - slid.time)).toBeLessThan(accuracy === 'fast' ? 0.05 : 1e-5);
      }
    }
    expect(off).toBeGreaterThan(4);
  });

  it('continues at low cost however small the holding force is', () => {
    // around the centre of the pull, the same small force holds her all the time
    const radius = 100;
    const pull = 39 * (1 - radius / 250);
    for (const rest of [1e-2, 1e-4, 1e-6, 1e-9]) {
      const level = onRim({
        astronaut: { x: -radius, y: 0, vy: Math.sqrt(radius * (pull - rest)) },
        asteroids: [{ x: 0, y: 0, radius: 16 }],
        repulsors: [{ x: 0, y: 0, radius }],
      });
      const budget = new WorkBudget(6000);
      const simulation = createSimulation(compile(level, accuracy), budget);
      simulation.advance(600, true);
      expect(simulation.modes.find(({ name }) => name === 'slide on a rim')?.share).toBeGreaterThan(0.999);
      const state = new Float64Array(STATE_SIZE);
      simulation.readState(state);
      expect(Math.abs(Math.hypot(state[0], state[1]) - radius)).toBeLessThan(1e-9);
    }
  });

  it('works between two fields that push towards each other, with the gun or without', () => {
    const repulsors = [
      { x: 0, y: 0, radius: 48 },
      { x: -70, y: 20, radius: 48 },
    ];
    const level = onRim({ repulsors });
    for (const holds of [
      [],
      [
        [0, 3],
        [7, 20],
      ] as Hold[],
      HELD,
    ]) {
      const run = play(level, accuracy, holds, 10);
      const until = run.events.find((e) => e.type === 'leave' && e.index === 1)?.time ?? 10;
      expect(until).toBeGreaterThan(0.5);
      for (const part of TIMES) expect(away(run, slideByAngle(level, until * part, 'fields'))).toBeLessThan(1e-9);
    }
  });

  it('ends with the hold: she flies straight on, or stays if she rests', () => {
    const level = onRim({ astronaut: { x: -48, y: 0, vy: 12 } });
    const run = play(level, accuracy, [[0, 30]], 2);
    const slid = slideByAngle(level, 0.5);
    const later = placeAt(run, 2);
    expect(leaves(run)).toBe(0.5);
    expect(Math.hypot(later[0] - slid.x - 1.5 * slid.vx, later[1] - slid.y - 1.5 * slid.vy)).toBeLessThan(3e-9);
    const still = play(onRim({ asteroids: [{ x: 70, y: 0, radius: 16 }] }), accuracy, [[0, 60]], 2);
    expect([still.final.x, still.final.y]).toEqual([expect.closeTo(-48, 10), 0]);
    expect(leaves(still)).toBe(1);
  });

  itQuick('touches objects at the rim when her box does', () => {
    const bare = onRim({ astronaut: { x: -48, y: 0, vy: 12 } });
    const gap = (time: number) => {
      const { x, y, rock } = slideByAngle(bare, time, 'gun', 2e-4);
      const d = Math.hypot(rock[0] - x, rock[1] - y);
      return boxCircleGap(DEFAULT_BOX, -35 - x, 62 - y, (rock[0] - x) / d, (rock[1] - y) / d, 16);
    };
    let [before, behind] = [0, 2.5];
    expect(gap(before)).toBeGreaterThan(0);
    expect(gap(behind)).toBeLessThan(0);
    for (let n = 0; n < 40; n++) {
      const middle = (before + behind) / 2;
      if (gap(middle) > 0) before = middle;
      else behind = middle;
    }
    const run = play({ ...bare, novae: [{ id: null, x: -35, y: 62, radius: 16 }] }, accuracy, HELD, 10);
    expect(run.with).toEqual({ kind: 'nova', index: 0 });
    expect(Math.abs(run.time - before)).toBeLessThan(OFF[accuracy] / 10 + 1e-9);
  });

  it('respects the speed limit along a rim of 100,000 px', () => {
    const level = plainLevel({
      range: 1e6,
      astronaut: { x: -1e5, y: 0, vy: 980 },
      asteroids: [{ x: 0, y: 5e4, radius: 16 }],
      repulsors: [{ x: 0, y: 0, radius: 1e5 }],
    });
    const run = play(level, accuracy, HELD, 10);
    expect(leaves(run)).toBeUndefined();
    for (const time of [2, 4, 7, 10]) {
      const [x, y, , vy] = placeAt(run, time);
      expect(Math.abs(Math.hypot(x, y) - 1e5)).toBeLessThan(1e-8);
      expect(vy).toBeLessThanOrEqual(1000);
    }
    expect(placeAt(run, 7)[3]).toBe(1000);
    expect(run.work.pieces).toBeLessThan(1000);
  });
});
