import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, createSimulation, playScript, STATE_SIZE, simulate, WorkBudget } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { continuousNames } from './accuracies.ts';
import { plainLevel } from './plain-level.ts';

/** Directions whose components have few digits. */
const direction = fc.constantFrom<readonly [x: number, y: number]>(
  [1, 0],
  [0, 1],
  [-1, 0],
  [0, -1],
  [0.6, 0.8],
  [-0.8, 0.6],
  [0.8, -0.6],
  [-0.6, -0.8],
);

const KINDS = ['mouth', 'exit', 'repulsor', 'wind', 'wind and repulsor', 'range'] as const;

interface Scene {
  readonly kind: (typeof KINDS)[number];
  /** Where she comes from, and how far and fast. */
  readonly way: readonly [x: number, y: number];
  readonly far: number;
  readonly speed: number;
  /** Her speed across the way, px/s. */
  readonly across: number;
  /** Towards the middle of the circle whose rim is the centre. */
  readonly middle: readonly [x: number, y: number];
  readonly r: number;
  readonly recoil: boolean;
}

/** She falls towards an asteroid in 30, 20, moved by (dx, dy), px, through whose centre a rim leads. */
function falls({ kind, way, far, speed, across, middle, r, recoil }: Scene, dx: number, dy: number): Level {
  const [x, y] = [30, 20];
  const circle = { id: null, x: x + r * middle[0], y: y + r * middle[1], radius: r };
  const range = kind === 'range' ? r + 200 : 1000;
  const second = { x: x + range * middle[0], y: y + range * middle[1], radius: 16 };
  const level = plainLevel({
    astronaut: {
      x: x - far * way[0],
      y: y - far * way[1],
      vx: speed * way[0] - across * way[1],
      vy: speed * way[1] + across * way[0],
    },
    range,
    recoil,
    asteroids: [{ x: x + dx, y: y + dy, radius: 16 }, ...(kind === 'range' ? [second] : [])],
    repulsors: kind.endsWith('repulsor') ? [circle] : [],
  });
  const half = { x: x - (far / 2) * way[0], y: y - (far / 2) * way[1], toX: circle.x, toY: circle.y };
  const through = { x: circle.x, y: circle.y, toX: x + 150, toY: y + 90 };
  return {
    ...level,
    winds: kind.startsWith('wind') ? [{ ...circle, ax: 20, ay: -7 }] : [],
    wormholes: kind === 'mouth' || kind === 'exit' ? [{ id: null, radius: r, ...(kind === 'mouth' ? through : half) }] : [],
  };
}

describe.each(continuousNames)('a rim through the centre of the target, %s', (accuracy) => {
  it('lets her pass as it does if the target is a billionth of a pixel aside', () => {
    fc.assert(
      fc.property(
        fc.record({
          kind: fc.constantFrom(...KINDS),
          way: direction,
          far: fc.constantFrom(40, 50, 65, 100),
          // some of them so small that they hardly are a direction
          speed: fc.constantFrom(0, 10, -10, 1e-9, 1e-13, 3e-18),
          across: fc.constantFrom(0, 0, 3e-18, 1e-15, 1e-13),
          middle: direction,
          r: fc.constantFrom(5, 13, 20, 25, 48),
          recoil: fc.boolean(),
        }),
        fc.constantFrom<Hold[]>(
          [[0, 120]],
          [
            [0, 30],
            [35, 120],
          ],
          [[3, 120]],
        ),
        (scene, holds) => {
          const play = (dx: number, dy: number) =>
            simulate(compile(falls(scene, dx, dy), accuracy), holds, { maxTime: 2.5, budget: new WorkBudget(20_000) });
          const run = play(0, 0);
          expect({ stopped: run.stopped, isFinite: Number.isFinite(run.final.x + run.final.y) }).toEqual({
            stopped: null,
            isFinite: true,
          });
          const aside = 1e-9;
          const near = [play(aside, 0), play(-aside, 0), play(0, aside), play(0, -aside)].map(({ final }) =>
            Math.hypot(final.x - run.final.x, final.y - run.final.y),
          );
          expect(Math.min(...near)).toBeLessThan(1e-4);
          // not recorded, steps may be skipped
          const silent = createSimulation(compile(falls(scene, 0, 0), accuracy));
          playScript(silent, holds, 150);
          const state = new Float64Array(STATE_SIZE);
          silent.readState(state);
          expect([state[0], state[1]]).toEqual([run.final.x, run.final.y]);
        },
      ),
      { numRuns: 40 },
    );
  });

  it('is crossed in the same way if steps are skipped, also where they are shorter than the last digit of the time', () => {
    const level: Level = {
      ...plainLevel({ astronaut: { x: 95, y: 0, vy: -1e-13 }, asteroids: [{ x: 30, y: 0, radius: 16 }], range: 1000 }),
      wormholes: [{ id: null, x: 30 - 0.8 * 48, y: 0.6 * 48, toX: 180, toY: 90, radius: 48 }],
    };
    const scene = compile(level, accuracy);
    const holds: Hold[] = [[3600, 3720]];
    const silent = createSimulation(scene);
    playScript(silent, holds, 3750);
    const state = new Float64Array(STATE_SIZE);
    silent.readState(state);
    const { x, y, vx, vy, cos, sin } = simulate(scene, holds, { maxTime: 3750 / 60 }).final;
    expect(state).toEqual(Float64Array.of(x, y, vx, vy, cos, sin));
  });

  it('or she comes to it all but at rest, out of a wormhole that took her at the start', () => {
    const level: Level = {
      ...plainLevel({ asteroids: [{ x: 0, y: 40, radius: 16 }], range: 300 }),
      wormholes: [{ id: null, x: 0, y: 20, toX: -20, toY: 100, radius: 20 }],
    };
    const { stopped, final, time } = simulate(compile(level, accuracy), [[0, 360]], {
      maxTime: 4,
      budget: new WorkBudget(20_000),
    });
    expect({ stopped, time }).toEqual({ stopped: null, time: 4 });
    expect(Number.isFinite(final.x + final.y)).toBe(true);
  });
});
