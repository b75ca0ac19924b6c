import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, type Run, simulate, WorkBudget } from '../../engine/index.ts';
import type { Asteroid, Level } from '../../schema/index.ts';
import { expectDeep } from '../depth.ts';
import { randomScene } from '../scenes/random-scene.ts';
import { continuousNames } from './accuracies.ts';
import { plainLevel } from './plain-level.ts';

// From 128 asteroids on, an index finds them; below that, they are checked one by one. Both must find the same.

const COUNT = 150;

/** 14 rows of 14, 60 px apart, with the start in the middle of four. */
const GRID = Array.from({ length: 196 }, (_, i) => ({ x: 60 * (i % 14) - 390, y: 60 * Math.floor(i / 14) - 390, radius: 2 }));

/** Asteroids that she can't reach, in random order. */
const farAway = ({ astronaut }: Level): Asteroid[] =>
  Array.from({ length: COUNT }, (_, i) => ({
    id: null,
    x: astronaut.x - 4e5,
    y: astronaut.y + 60 * ((7 * i) % COUNT),
    radius: 16,
    hot: false,
  }));

const play = (
  level: Level,
  accuracy: (typeof continuousNames)[number],
  holds: ReturnType<typeof randomScene>['holds'],
  maxTime = 10,
) => simulate(compile(level, accuracy), holds, { maxTime, budget: new WorkBudget(50_000) });

/** A run without numbers, with the indices of asteroids relative to the first one. */
function told({ outcome, with: what, events }: Run, first: number): unknown {
  const own = <T extends object>(of: T, kind: string): T =>
    'index' in of && typeof of.index === 'number' && (kind === 'asteroid' || kind === 'target')
      ? { ...of, index: of.index - first }
      : of;
  return [
    outcome,
    what === null ? null : own(what, what.kind),
    events.map((event) => {
      const one = { ...own(event, event.type), time: 0 };
      return 'with' in one && one.with !== null ? { ...one, with: own(one.with, one.with.kind) } : one;
    }),
  ];
}

// pieces are shorter with an index, so that last digits may differ
describe.each(continuousNames)('distant asteroids change nothing: %s', (accuracy) => {
  it.each([
    ['behind', 0],
    ['before', COUNT],
  ] as const)('%s the others in the list', (_, first) => {
    let stopped = 0;
    fc.assert(
      fc.property(fc.nat(1_000_000), (seed) => {
        const { level, holds, maxTime } = randomScene(seed);
        const far = farAway(level);
        const more = { ...level, asteroids: first === 0 ? [...level.asteroids, ...far] : [...far, ...level.asteroids] };
        const few = play(level, accuracy, holds, maxTime);
        const all = play(more, accuracy, holds, maxTime);
        if (few.stopped !== null || all.stopped !== null) {
          stopped++;
          return;
        }
        expect(told(all, first)).toEqual(told(few, 0));
        for (const [i, { time }] of few.events.entries()) expect(Math.abs(all.events[i].time - time)).toBeLessThan(1e-8);
        expect(Math.hypot(all.final.x - few.final.x, all.final.y - few.final.y)).toBeLessThan(1e-5);
      }),
      { numRuns: 50 },
    );
    expectDeep(stopped).toBeLessThan(3);
  });

  // while the gun is held, places are relative to the target, and another asteroid may have become the nearest
  it('the nearest asteroid is found wherever recoil has moved them', () => {
    for (const recoil of [false, true]) {
      const level = plainLevel({ range: 100, recoil, astronaut: { x: 3, y: 8, vx: 70, vy: 31 }, asteroids: GRID });
      const run = play(level, accuracy, [
        [0, 20],
        [25, 60],
        [90, 91],
        [120, 200],
        [210, 300],
      ]);
      const at = new Float64Array(6);
      const rocks = new Float64Array(2 * GRID.length);
      let targets = 0;
      for (const event of run.events) {
        if (event.type !== 'target') continue;
        targets++;
        run.trajectory.at(event.time, at);
        run.trajectory.asteroidsAt(event.time, rocks);
        const far = (i: number) => Math.hypot(rocks[2 * i] - at[0], rocks[2 * i + 1] - at[1]);
        const nearest = Math.min(...GRID.map((_, i) => far(i)));
        expect(far(event.index) - nearest).toBeLessThan(1e-3);
      }
      expect(targets).toBeGreaterThan(5);
    }
  });

  it('the first in the list of several at the same distance is the target', () => {
    for (const turn of [0, 7, 60, 119]) {
      const turned = [...GRID.slice(turn), ...GRID.slice(0, turn)];
      const run = play(plainLevel({ range: 100, astronaut: { x: 0, y: 0 }, asteroids: turned }), accuracy, [[0, 5]], 0.1);
      const first = turned.findIndex(({ x, y }) => Math.abs(x) === 30 && Math.abs(y) === 30);
      expect(run.events.find(({ type }) => type === 'target')).toMatchObject({ index: first });
    }
  });
});
