import { describe, expect } from 'vitest';
import { compile, simulate } from '../../../engine/index.ts';
import type { Hold, Level, LevelFile } from '../../../schema/index.ts';
import type { FanGrid, Flowpipe, PipeGrid } from '../../../solver/index.ts';
import { describeQuick, itQuick as it, itDeep } from '../../depth.ts';
import {
  type Asked,
  at,
  BOX,
  doomedBy,
  FRAMES,
  flowpipeBy,
  hot,
  levelWith,
  type Maker,
  type NearMiss,
  nearMisses,
  ORIGIN,
  RANGE,
  spot,
  TICK,
  whyNot,
} from './near-miss.ts';

// Reachable sets contain more than what she can do, so their slack is more than rounding: it is measured, and stated to some
// hundredths. What is false is known from simulation, or from the energy of one pull.

type Follow = (steps: number, more?: Partial<FanGrid & PipeGrid>) => Maker;
const doomed: Follow = (steps, more) => doomedBy({ axis: [1, 0], cell: 8, bin: 4, frames: 4, ...more }, steps);
const flowpipe: Follow = (steps, more) => flowpipeBy({ axis: [1, 0], cell: 16, frames: 4, steps, turns: 4, ...more });

const HELD: readonly Hold[] = [[0, 3600]];
const moving = (vx: number, vy: number, more: Partial<LevelFile>): Level =>
  levelWith({ astronaut: { ...ORIGIN, vx, vy }, ...more });
const MINERAL = { kind: 'mineral', index: 0 } as const;

/**
 * The speed that takes her out of range against the pull of one asteroid 200 px away: v² / 2 = 39 (50 - (250² - 200²) / 500).
 */
const ESCAPE = Math.sqrt(2 * 39 * (50 - (RANGE ** 2 - 200 ** 2) / (2 * RANGE)));

/**
 * The number at which the outcome of a run with the gun held changes, between one where it is as given and one where it is not.
 */
function playedEdge(so: number, not: number, ends: (n: number) => boolean): number {
  let [a, b] = [so, not];
  if (!ends(a) || ends(b)) throw new Error('expected an end between the two');
  for (let i = 0; i < 20; i++) {
    const middle = (a + b) / 2;
    if (ends(middle)) a = middle;
    else b = middle;
  }
  return (a + b) / 2;
}
const outcome = (level: Level, holds = HELD): string => simulate(compile(level), holds, { maxTime: 5 }).outcome;

const away = (v: number, more: Partial<LevelFile> = {}) => moving(-v, 0, { asteroids: [at(200, 0)], ...more });
const turning = (x: number, more: Partial<LevelFile> = {}) =>
  moving(-40, 0, { asteroids: [at(100, 0)], novae: [at(-x, 0, 20)], ...more });

describeQuick.each([
  ['doomed', doomed],
  ['flowpipe', flowpipe],
] as const)('%s', (kind, follow) => {
  const isPipe = kind === 'flowpipe';
  const slack = (ofDoomed: number, ofPipe: number): readonly [number, number] => {
    const measured = isPipe ? ofPipe : ofDoomed;
    return [measured - 0.03, measured + 0.03];
  };
  const goesOn = (steps: number) => `some runs may continue after ${steps} steps`;
  const turn = playedEdge(50, 90, (x) => outcome(turning(x)) === 'collided');
  const cases: Record<string, NearMiss> = {
    'the speed to get out of range': {
      why: (v) => whyNot(away(v), follow(60)),
      truth: ESCAPE,
      safe: 'above',
      slack: slack(2.064, 1.983),
      says: goesOn(60),
      grain: 0.02,
    },
    'with recoil': {
      why: (v) => whyNot(away(v, { recoil: true, asteroids: [at(200, 0, 20)] }), follow(60), { maxTime: 60 }),
      truth: ESCAPE,
      safe: 'above',
      slack: slack(2.192, 2.111),
      says: goesOn(60),
      grain: 0.02,
    },
    'along the axis of the grid': {
      why: (v) => whyNot(moving(0.6 * v, -0.8 * v, { asteroids: [at(-120, 160)] }), follow(60, { axis: [0.6, -0.8] })),
      truth: ESCAPE,
      safe: 'above',
      slack: slack(2.064, 1.983),
      says: goesOn(60),
      grain: 0.02,
    },
    'aslant to the axis of the grid': {
      why: (v) => whyNot(moving(-0.6 * v, 0.8 * v, { asteroids: [at(120, -160)] }), follow(60)),
      truth: ESCAPE,
      safe: 'above',
      slack: slack(2.094, 2.094),
      says: goesOn(60),
      grain: 0.02,
    },
    'between two asteroids that are as near': {
      why: (v) => whyNot(moving(-v, 0, { asteroids: [at(180, 90), at(180, -90)] }), follow(60)),
      truth: playedEdge(30, 15, (v) => outcome(moving(-v, 0, { asteroids: [at(180, 90), at(180, -90)] })) === 'lost'),
      safe: 'above',
      slack: isPipe ? [0.5, 5] : [0.5, 5],
      says: goesOn(60),
      reach: 8,
      grain: 0.02,
    },
    'a field that pushes her out': {
      why: (radius) => whyNot(moving(-12, 0, { asteroids: [at(200, 0)], repulsors: [at(30, 0, radius)] }), follow(80)),
      truth: playedEdge(
        45,
        31,
        (radius) => outcome(moving(-12, 0, { asteroids: [at(200, 0)], repulsors: [at(30, 0, radius)] })) === 'lost',
      ),
      safe: 'above',
      slack: [1, 1.7],
      says: goesOn(80),
      reach: 2,
      grain: 0.05,
    },
    'a nova that she comes to before she can turn back': {
      why: (x) => whyNot(turning(x), follow(60)),
      truth: turn,
      safe: 'below',
      slack: [0, 5],
      says: goesOn(60),
      reach: 8,
      grain: 0.02,
    },
    'a black hole before a mineral': {
      why: (x) =>
        whyNot(turning(0, { novae: [], blackHole: { ...spot(-x, 0), radius: 20 }, minerals: [spot(700, 700)] }), follow(60), {
          about: MINERAL,
        }),
      truth: turn,
      safe: 'below',
      slack: [0, 5],
      says: goesOn(60),
      reach: 8,
      grain: 0.02,
    },
    'a second asteroid whose range takes her up': {
      why: (x) => whyNot(away(40, { asteroids: [at(200, 0), at(-x, 0)] }), follow(60)),
      truth: 300,
      safe: 'above',
      slack: slack(3.333, 6),
      says: goesOn(60),
      reach: 8,
      grain: 0.02,
    },
    'a black hole beside her way': {
      why: (d) => whyNot(away(40, { blackHole: spot(-20, d) }), follow(60)),
      truth: 18 + BOX.halfHeight,
      safe: 'above',
      slack: slack(2.977, 2.965),
      says: 'she may touch it in step',
      grain: 0.005,
    },
    'a black hole at the other side, behind the start': {
      why: (d) => whyNot(away(40, { blackHole: spot(5, -d) }), follow(60)),
      truth: 18 + BOX.halfHeight,
      safe: 'above',
      slack: [2.62, 2.67],
      says: 'she may touch it in step',
      grain: 0.005,
    },
    'a black hole towards which she is pulled': {
      why: (d) => whyNot(moving(0, -60, { asteroids: [at(230, 0)], blackHole: spot(d, -30) }), follow(40)),
      truth: playedEdge(
        20,
        40,
        (d) => outcome(moving(0, -60, { asteroids: [at(230, 0)], blackHole: spot(d, -30) })) === 'completed',
      ),
      safe: 'above',
      slack: [8, 10],
      says: 'she may touch it in step',
      reach: 12,
      grain: 0.02,
    },
    'the speed limit': {
      why: (v) => whyNot(away(v), follow(10)),
      // A flowpipe allows for the full pull all the time, and both stay below half of the limit.
      truth: (isPipe ? 500 - 39 * 10 * 4 * TICK : 500) + 1e-6,
      safe: 'below',
      slack: [0, 1e-5],
      says: 'she may reach the speed limit',
    },
  };
  nearMisses(cases);

  it('the steps of the longest run, and one less', () => {
    // Without the gun she is out of range after 50 px, at 40 px/s; with it, later.
    const lost = simulate(compile(away(40)), HELD).time / (4 * TICK);
    const least = [...Array(60).keys()]
      .slice(Math.max(3, Math.floor(lost) - 1))
      .find((steps) => whyNot(away(40), follow(steps)) === null) as number;
    expect(least).toBeGreaterThanOrEqual(lost);
    expect(least - lost).toBeLessThan(1.5);
    expect(whyNot(away(40), follow(least - 1))).toBe(goesOn(least - 1));
  });

  it('what stops her, and what does not', () => {
    const asked: Asked = { covers: ['precise'] };
    const stops = (more: Partial<LevelFile>) => whyNot(turning(0, { novae: [], ...more }), follow(20), asked);
    expect(stops({ novae: [at(-50, 0, 20)] })).toBeNull();
    expect(stops({ asteroids: [at(100, 0), hot(-50, 0, 4)] })).toBeNull();
    expect(stops({ asteroids: [at(100, 0), at(-50, 0, 20)] })).not.toBeNull();
    expect(stops({ blackHole: { ...spot(-50, 0), radius: 20 } })).toContain('she may touch it');
    expect(stops({ repulsors: [at(-90, 0, 20)] })).not.toBeNull();
  });
});

describe('doomed alone', () => {
  it('holds for frames, too, with one rule for both', () => {
    expect(whyNot(turning(60), doomed(60), { covers: FRAMES })).toBeNull();
    expect(whyNot(turning(75), doomed(60), { covers: FRAMES })).toBe('some runs may continue after 60 steps');
  });

  itDeep('examines no more pieces of boxes than allowed', () => {
    const level = moving(-60, 20, { asteroids: [at(50, 0)] });
    const grid = { axis: [1, 0], cell: 0.25, bin: 0.25, frames: 1 } as const;
    const { layers } = doomedBy(grid, 1)(level);
    const lost = [-9000, -8000, -9000, -8000, -300, 300, -300, 300];
    expect(whyNot(level, { kind: 'doomed', grid, layers: [[lost, ...layers[0]]] })).toBe('following her takes too many boxes');
  });

  nearMisses({
    'a nova aside: no more of her box than the circle in it is sure to touch': {
      why: (y) => whyNot(moving(-40, 0, { asteroids: [at(100, 0)], novae: [at(-50, y, 30)] }), doomed(40)),
      // Upright, her box extends 16 px vertically, until it is turned towards the asteroid.
      truth: 30 + BOX.halfHeight,
      safe: 'below',
      slack: [8, 8.3],
      says: 'some runs may continue after 40 steps',
      reach: 10,
      grain: 0.05,
    },
  });
});

describe('flowpipe alone', () => {
  const fine = { cell: 3.5, frames: 2, turns: 8 };
  const past = (more: Partial<LevelFile>) => moving(60, 0, { asteroids: [at(150, 0)], blackHole: spot(300, 0), ...more });
  const says = 'some runs may continue after 22 steps';
  nearMisses({
    'an alien beside her way': {
      why: (y) => whyNot(past({ aliens: [at(70, y, 25)] }), flowpipe(22, fine)),
      truth: 25 + BOX.halfHeight + 1,
      safe: 'below',
      slack: [5, 5.3],
      says,
      reach: 12,
      grain: 0.02,
    },
    'an alien that is too far ahead to be met in time': {
      why: (x) => whyNot(past({ aliens: [at(x, 5, 25)] }), flowpipe(22, fine)),
      truth: 88,
      safe: 'below',
      slack: [7.2, 7.35],
      says,
      reach: 15,
      grain: 0.02,
    },
    'two aliens that may explode before she comes': {
      why: (y) => whyNot(past({ aliens: [at(70, 5, 25), at(70, 5 + y, 25)] }), flowpipe(22, fine)),
      truth: 50,
      safe: 'above',
      slack: [1.1, 1.25],
      says,
      reach: 8,
      grain: 0.02,
    },
    'a nova beside her way, which her box as it is turned touches': {
      why: (y) => whyNot(past({ novae: [at(70, y, 25)] }), flowpipe(22, fine)),
      truth: 25 + BOX.halfHeight,
      safe: 'below',
      slack: [6.6, 6.8],
      says,
      reach: 15,
      grain: 0.02,
    },
  });

  it('does not cover frames', () => {
    expect(whyNot(turning(60), flowpipe(60))).toBeNull();
    expect(whyNot(turning(60), flowpipe(60), { covers: FRAMES })).toBe(
      'with frames pushes and contacts happen only once a frame',
    );
  });

  itDeep('follows no more pieces than allowed', () => {
    const level = moving(-60, 20, { asteroids: [at(50, 0)] });
    const made = flowpipe(12)(level) as Flowpipe;
    // 316 lines in each direction cut the set into nothing 100,488 times, and into one part that goes on.
    const far = Array.from({ length: 316 }, (_, n) => 8000 + n);
    const parts = Array.from({ length: 317 * 317 }, () => ({ off: [], to: 0 }));
    const cut = { cuts: [far, far, [], []], parts };
    expect(whyNot(level, { ...made, layers: [[[cut, cut]], ...made.layers.slice(1)] })).toBe(
      'it does not say how a set continues in step 1',
    );
    const half = { cuts: [far.slice(0, 223), far.slice(0, 223), [], []], parts: parts.slice(0, 224 * 224) };
    expect(whyNot(level, { ...made, layers: [[[half, half]], ...made.layers.slice(1)] })).toBe(
      'following her takes too many pieces',
    );
  });
});
