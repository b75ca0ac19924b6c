import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, type Run, simulate, WorkBudget } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { expectDeep } from '../depth.ts';
import { randomScene } from '../scenes/random-scene.ts';
import { seeded } from '../scenes/seeded.ts';
import { windyScene } from '../scenes/windy-scene.ts';
import { continuousNames } from './accuracies.ts';
import { flipped, imageOf, swapped } from './image.ts';
import { plainLevel } from './plain-level.ts';

// Nothing in continuous time distinguishes right from left, or the axes: a bug in one of them shows in the image.

const SEED = fc.nat(1_000_000);

describe.each(continuousNames)('the image of a scene gives the image of its run: %s', (accuracy) => {
  const play = (level: Level, holds: readonly Hold[], maxTime: number): Run =>
    simulate(compile(level, accuracy), holds, { maxTime, budget: new WorkBudget(50_000) });

  it('left for right, bit for bit', () => {
    fc.assert(
      fc.property(SEED, (seed) => {
        const { level, holds, maxTime } = (seed % 2 === 0 ? randomScene : windyScene)(seed);
        const run = play(level, holds, maxTime);
        const image = play(imageOf(level, flipped), holds, maxTime);
        expect([image.outcome, image.with, image.time, image.events]).toEqual([run.outcome, run.with, run.time, run.events]);
        const { x, y, vx, vy } = image.final;
        const { final } = run;
        // whichever of the two zeros it is
        expect([0 - x, y + 0, 0 - vx, vy + 0]).toEqual([final.x + 0, final.y + 0, final.vx + 0, final.vy + 0]);
      }),
      { numRuns: 25 },
    );
  });

  it('x for y, except the box, which is upright at the start', () => {
    let compared = 0;
    fc.assert(
      fc.property(SEED, (seed) => {
        const scene = (seed % 2 === 0 ? randomScene : windyScene)(seed);
        const { x, y } = scene.level.astronaut;
        const isClear = (o: { x: number; y: number; radius: number }) => Math.hypot(o.x - x, o.y - y) > o.radius + 30;
        const level = { ...scene.level, minerals: scene.level.minerals.filter(isClear) };
        // held from the start on she looks to where the gun draws her
        const holds: Hold[] = [[0, scene.holds[0]?.[1] ?? 30], ...scene.holds.slice(1)];
        const run = play(level, holds, scene.maxTime);
        const image = play(imageOf(level, swapped), holds, scene.maxTime);
        if (run.time === 0 || image.time === 0) return;
        compared++;
        const told = ({ outcome, with: what, events }: Run) => [outcome, what, events.map((event) => ({ ...event, time: 0 }))];
        expect(told(image)).toEqual(told(run));
        // sums may be taken in another order
        expect(Math.abs(image.time - run.time)).toBeLessThan(1e-9);
        for (const [i, { time }] of run.events.entries()) expect(Math.abs(image.events[i].time - time)).toBeLessThan(1e-9);
        expect(Math.hypot(image.final.x - run.final.y, image.final.y - run.final.x)).toBeLessThan(1e-6);
        expect(Math.hypot(image.final.vx - run.final.vy, image.final.vy - run.final.vx)).toBeLessThan(1e-6);
      }),
      { numRuns: 25 },
    );
    expectDeep(compared).toBeGreaterThan(16);
  });

  // the frame goes with the rock until she is in the field
  it('x for y, where she slides along a rim while recoil moves the target', () => {
    let slides = 0;
    fc.assert(
      fc.property(SEED, (seed) => {
        const random = seeded(seed);
        const angle = 2 * Math.PI * random();
        const [c, s] = [Math.cos(angle), Math.sin(angle)];
        const radius = 30 + 60 * random();
        const out = 3e-7 * random();
        const along = 10 * (random() - 0.5);
        const level = plainLevel({
          range: 250,
          recoil: true,
          astronaut: { x: (radius + out) * c, y: (radius + out) * s, vx: -along * s, vy: along * c },
          asteroids: [{ x: -70 * c + 40 * (random() - 0.5), y: -70 * s + 40 * (random() - 0.5), radius: 0.5 + random() }],
          repulsors: [{ x: 0, y: 0, radius }],
        });
        const run = play(level, [[0, 60]], 1);
        const image = play(imageOf(level, swapped), [[0, 60]], 1);
        if (run.modes.some(({ name, share }) => name === 'slide on a rim' && share > 0.1)) slides++;
        expect(Math.hypot(image.final.x - run.final.y, image.final.y - run.final.x)).toBeLessThan(1e-5);
        expect(Math.hypot(image.final.vx - run.final.vy, image.final.vy - run.final.vx)).toBeLessThan(1e-5);
      }),
      { numRuns: 8 },
    );
    expectDeep(slides).toBeGreaterThan(2);
  });
});
