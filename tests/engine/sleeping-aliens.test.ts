import fc from 'fast-check';
import { expect, it } from 'vitest';
import {
  type AccuracyName,
  compile,
  createSimulation,
  joinHolds,
  playScript,
  simulate,
  unlimited,
  type WorkBudget,
} from '../../engine/index.ts';
import type { Circle, Level } from '../../schema/index.ts';
import { expectDeep } from '../depth.ts';
import { randomScene } from '../scenes/random-scene.ts';
import { seeded } from '../scenes/seeded.ts';
import { plainLevel } from './plain-level.ts';

const ACCURACY = fc.constantFrom<AccuracyName>('precise', 'standard', 'fast', 'arcade');
const SEED = fc.nat(1_000_000);

const circle = (x: number, y: number, radius: number): Circle => ({ id: null, x, y, radius });

/** Sleeping aliens that she can't reach, in random order. */
const farAway = ({ astronaut }: Level, count: number): Circle[] =>
  Array.from({ length: count }, (_, i) => circle(astronaut.x + 3e5 + 60 * ((7 * i) % count), astronaut.y - 3e5, 5));

/** A scene crowded with aliens. */
function crowd(seed: number, count: number): ReturnType<typeof randomScene> {
  const scene = randomScene(seed);
  const random = seeded(seed + 1);
  const { x, y } = scene.level.astronaut;
  const radius = [0.01, 3, 10][seed % 3];
  const aliens = Array.from({ length: count }, () => circle(x + 800 * (random() - 0.5), y + 800 * (random() - 0.5), radius));
  return { ...scene, level: { ...scene.level, aliens } };
}

/** Her orbit is in the middle of a ring of aliens: most of them see her, chase her, and meet each other. */
function chasing(seed: number, count: number): Level {
  const random = seeded(seed);
  const aliens: Circle[] = [];
  while (aliens.length < count) {
    const angle = 2 * Math.PI * random();
    const far = 125 + 65 * random();
    const one = circle(far * Math.cos(angle), 50 + far * Math.sin(angle), 0.5 + 3 * random());
    const isClear = aliens.every(({ x, y, radius }) => Math.hypot(x - one.x, y - one.y) > radius + one.radius);
    if (isClear) aliens.push(one);
  }
  return plainLevel({
    astronaut: { x: 0, y: 0, vx: Math.sqrt(39 * 50) },
    asteroids: [{ x: 0, y: 50, radius: 5 }],
    aliens,
  });
}

// a list of 12 is checked one by one, one of 300 through the index
it('distant sleeping aliens change no bit of the others', () => {
  fc.assert(
    fc.property(SEED, ACCURACY, (seed, accuracy) => {
      const { level, holds, maxTime } = crowd(seed, 12);
      const many = { ...level, aliens: [...level.aliens, ...farAway(level, 300)] };
      const few = simulate(compile(level, accuracy), holds, { maxTime });
      const all = simulate(compile(many, accuracy), holds, { maxTime });
      expect([all.hash, all.events, all.clearance]).toEqual([few.hash, few.events, few.clearance]);
    }),
    { numRuns: 8 },
  );
});

const CONTINUOUS = fc.constantFrom<AccuracyName>('precise', 'standard', 'fast');

// more than 16 awake aliens are checked through an index, too
it('two aliens of a chasing crowd explode when they touch, and no others touch', () => {
  let explosions = 0;
  fc.assert(
    fc.property(SEED, CONTINUOUS, fc.constantFrom(20, 60), (seed, accuracy, count) => {
      const level = chasing(seed, count);
      const run = simulate(compile(level, accuracy), [[0, 600]], { maxTime: 8 });
      const places = new Float64Array(3 * count);
      const gap = (i: number, j: number) => {
        const centres = Math.hypot(places[3 * i] - places[3 * j], places[3 * i + 1] - places[3 * j + 1]);
        return centres - level.aliens[i].radius - level.aliens[j].radius;
      };
      for (const event of run.events) {
        if (event.type !== 'explosion') continue;
        explosions++;
        run.trajectory.aliensAt(event.time - 1e-7, places);
        expect(Math.abs(gap(...event.aliens))).toBeLessThan(1e-4);
      }
      for (let time = 1 / 30; time < run.time; time += 1 / 30) {
        run.trajectory.aliensAt(time, places);
        for (let i = 0; i < count; i++) {
          for (let j = 0; places[3 * i + 2] === 1 && j < i; j++) {
            if (places[3 * j + 2] === 1 && gap(i, j) < -1e-9) expect.fail(`${i} and ${j} overlap at ${time} s`);
          }
        }
      }
    }),
    { numRuns: 10 },
  );
  expectDeep(explosions).toBeGreaterThan(20);
});

const explosionsOf = (aliens: readonly Circle[], accuracy: AccuracyName) =>
  simulate(compile(plainLevel({ aliens }), accuracy), [], { maxTime: 5 }).events.filter(({ type }) => type === 'explosion');

// one that chases her from rest, while she rests, comes nearer by 4 t2
it('two aliens of a crowd that chase her side by side touch at the time of a closed form', () => {
  fc.assert(
    fc.property(SEED, CONTINUOUS, fc.constantFrom(1, 7, 9, 12), (seed, accuracy, pairs) => {
      const random = seeded(seed);
      const apart = 0.05;
      const aliens: Circle[] = [];
      const expected: number[] = [];
      for (let k = 0; k < pairs; k++) {
        const angle = (2 * Math.PI * (k + 0.3 * random())) / pairs;
        const [far, a, b] = [100 + 45 * random(), 3 + random(), 3 + random()];
        aliens.push(circle(far * Math.cos(angle - apart), far * Math.sin(angle - apart), a));
        aliens.push(circle(far * Math.cos(angle + apart), far * Math.sin(angle + apart), b));
        expected.push(Math.sqrt((far - (a + b) / (2 * Math.sin(apart))) / 4));
      }
      const times = explosionsOf(aliens, accuracy).map(({ time }) => time);
      expect(times).toHaveLength(pairs);
      for (const [i, time] of expected.sort((a, b) => a - b).entries()) expect(Math.abs(times[i] - time)).toBeLessThan(1e-6);
    }),
    { numRuns: 8 },
  );
});

it('an alien of a crowd that chases her past a large sleeping one touches it at the time of a closed form', () => {
  fc.assert(
    fc.property(SEED, CONTINUOUS, fc.constantFrom(0, 30, 300), fc.boolean(), (seed, accuracy, others, isFirst) => {
      const random = seeded(seed);
      const angle = 2 * Math.PI * random();
      const turned = (x: number, y: number, radius: number) =>
        circle(x * Math.cos(angle) - y * Math.sin(angle), x * Math.sin(angle) + y * Math.cos(angle), radius);
      // 101 px between the centres: at 20 px along the way beside 99 px across it
      const pair = [turned(0, 140, 1), turned(99, 115, 100)];
      const more = farAway(plainLevel(), others);
      const aliens = isFirst ? [...pair, ...more] : [...more, pair[1], pair[0]];
      const times = explosionsOf(aliens, accuracy).map(({ time }) => time);
      expect(times).toHaveLength(1);
      expect(Math.abs(times[0] - Math.sqrt(5 / 4))).toBeLessThan(1e-6);
    }),
    { numRuns: 16 },
  );
});

it('a sleeping alien that is large enough to touch before it wakes ends the run at the time of a closed form', () => {
  fc.assert(
    fc.property(
      SEED,
      CONTINUOUS,
      fc.constantFrom(0, 30, 300),
      fc.constantFrom(141, 200, 1000, 1e4),
      (seed, accuracy, others, radius) => {
        const random = seeded(seed);
        const [speed, gap] = [100 + 800 * random(), 50 + 1500 * random()];
        for (const [ux, uy, half] of [
          [1, 0, 10],
          [-1, 0, 10],
          [0, 1, 16],
          [0, -1, 16],
        ]) {
          const far = radius + half + gap;
          const large = circle(far * ux, far * uy, radius);
          const beside = circle(-50 * ux - 400 * uy, -50 * uy + 400 * ux, 5);
          const level = plainLevel({
            astronaut: { x: 0, y: 0, vx: speed * ux, vy: speed * uy },
            aliens: [beside, ...farAway(plainLevel(), others), large],
          });
          const run = simulate(compile(level, accuracy), [], { maxTime: 30 });
          expect(run.with).toEqual({ kind: 'alien', index: level.aliens.length - 1 });
          expect(Math.abs(run.time - gap / speed)).toBeLessThan(1e-9);
          expect(run.events.some(({ type }) => type === 'wake')).toBe(false);
        }
      },
    ),
    { numRuns: 8 },
  );
});

it('a sleeping alien that is large enough to touch before it wakes is as deadly as a nova of its size', () => {
  let touched = 0;
  fc.assert(
    fc.property(SEED, CONTINUOUS, fc.constantFrom(0, 30, 300), (seed, accuracy, others) => {
      const random = seeded(seed);
      const radius = 160 + 400 * random();
      const angle = 2 * Math.PI * random();
      const far = radius + 20 + 100 * random();
      const large = circle(far * Math.cos(angle), far * Math.sin(angle), radius);
      const level = plainLevel({
        astronaut: { x: 0, y: 0, vx: 120 * (random() - 0.5), vy: 120 * (random() - 0.5) },
        asteroids: [{ x: 150 * random(), y: 150 * random(), radius: 16 }],
        range: 1000,
      });
      const holds: [number, number][] = [
        [10, 200],
        [260, 500],
      ];
      const beyond = farAway(plainLevel(), others);
      const alien = simulate(compile({ ...level, aliens: [...beyond, large] }, accuracy), holds, { maxTime: 10 });
      const nova = simulate(compile({ ...level, novae: [large], aliens: beyond }, accuracy), holds, { maxTime: 10 });
      expect([alien.outcome, alien.with?.kind ?? 'nothing']).toEqual([nova.outcome, nova.with === null ? 'nothing' : 'alien']);
      expect(Math.abs(alien.time - nova.time)).toBeLessThan(1e-9);
      if (nova.with !== null) touched++;
    }),
    { numRuns: 16 },
  );
  expectDeep(touched).toBeGreaterThan(5);
});

it('a crowd continues in the same way after a reset or a restore', () => {
  fc.assert(
    fc.property(SEED, ACCURACY, fc.integer({ min: 1, max: 200 }), (seed, accuracy, tick) => {
      const { level, holds } = crowd(seed, 150);
      const simulation = createSimulation(compile(level, accuracy));
      const aliens = new Float64Array(3 * level.aliens.length);
      const script = joinHolds(holds);
      const end = (): string => {
        playScript(
          simulation,
          script.map(([a, b]) => [Math.max(a, simulation.tick), b] as const).filter(([a, b]) => b > a),
          300,
        );
        simulation.readAliens(aliens);
        return `${JSON.stringify(simulation.ending)} ${simulation.tick} ${aliens}`;
      };
      const whole = end();
      simulation.reset();
      expect(end()).toBe(whole);
      simulation.reset();
      playScript(simulation, script, tick);
      const snapshot = simulation.snapshot();
      expect(end()).toBe(whole);
      simulation.restore(snapshot);
      expect(end()).toBe(whole);
      simulation.reset();
      expect(end()).toBe(whole);
    }),
    { numRuns: 12 },
  );
});

it.each([8, 100, 1000, 20_000])('%i sleeping aliens cost no work', (count) => {
  const level: Level = {
    ...randomScene(1).level,
    astronaut: { x: 0, y: 0, vx: 0, vy: 40 },
    blackHole: { x: 0, y: 5000, radius: 18 },
    range: 250,
    recoil: false,
    asteroids: [{ ...circle(100, 0, 16), hot: false }],
    novae: [],
    repulsors: [],
    minerals: [],
    aliens: [],
  };
  for (const accuracy of ['precise', 'standard', 'fast', 'arcade'] as const) {
    const looksOf = (aliens: readonly Circle[]): number => {
      const budget: WorkBudget = unlimited();
      const simulation = createSimulation(compile({ ...level, aliens }, accuracy), budget);
      // until she first presses she might drift anywhere: that is looked at once, as the simulation is made
      const made = budget.looks;
      playScript(simulation, [[0, 3600]], 3600);
      expect(simulation.ending).toBeNull();
      return budget.looks - made;
    };
    const ring = Array.from({ length: count }, (_, i) => circle(3000 + 60 * (i % 150), 3000 + 60 * Math.floor(i / 150), 25));
    expect(looksOf(ring) / looksOf([])).toBeLessThan(1.03);
  }
});

it('every alien keeps its initial state until one can wake, also after a snapshot and a reset', () => {
  let hasBeenCalm = false;
  let hasStirred = false;
  fc.assert(
    fc.property(SEED, ACCURACY, fc.boolean(), fc.nat(90), (seed, accuracy, isChased, at) => {
      const { level, holds } = crowd(seed, 12);
      const simulation = createSimulation(compile(isChased ? chasing(seed, 6) : level, accuracy));
      const script = joinHolds(holds);
      const count = simulation.scene.aliens.count;
      const start = new Float64Array(3 * count);
      const now = new Float64Array(3 * count);
      simulation.readAliens(start);
      const look = () => {
        if (simulation.mayAliensHaveStirred) return;
        simulation.readAliens(now);
        expect([...now]).toEqual([...start]);
        hasBeenCalm ||= simulation.tick > 0;
      };
      const play = (until: number) => {
        while (simulation.tick < until && simulation.ending === null) {
          const { tick } = simulation;
          simulation.advance(
            1,
            script.some(([press, release]) => press <= tick && tick < release),
          );
          look();
        }
      };
      play(at);
      const snapshot = simulation.snapshot();
      play(180);
      simulation.readAliens(now);
      hasStirred ||= now.some((value, i) => value !== start[i]);
      simulation.restore(snapshot);
      look();
      play(120);
      simulation.reset();
      look();
      play(60);
    }),
    { numRuns: 40 },
  );
  expectDeep([hasBeenCalm, hasStirred]).toEqual([true, true]);
});
