import { describe } from 'vitest';
import { compile, simulate } from '../../../engine/index.ts';
import type { Hold, Level, LevelFile } from '../../../schema/index.ts';
import type { Orbits } from '../../../solver/index.ts';
import { type Asked, at, BOX, levelWith, type NearMiss, nearMisses, ORIGIN, PULL, RANGE, spot, whyNot } from './near-miss.ts';

// Near misses of `orbits`: sets of states that the checker computes over a grid contain more than what she can do, so their slack
// is more than rounding. What is false is known from the energy of one pull, or from simulation.

const orbits = (steps: number, size = 2, frames = 4): Orbits => ({
  kind: 'orbits',
  grid: { place: size, speed: size, momentum: 40 * size, frames },
  steps,
});
const PRECISE: Asked = { covers: ['precise'] };
const check = (level: Level, certificate: Orbits, asked: Asked = PRECISE) => whyNot(level, certificate, asked);

const moving = (vx: number, vy: number, more: Partial<LevelFile>): Level =>
  levelWith({ astronaut: { ...ORIGIN, vx, vy }, ...more });
const away = (v: number, more: Partial<LevelFile> = {}) => moving(-v, 0, { asteroids: [at(200, 0)], ...more });

/** What the pull takes from v² / 2 on the way from 200 px to the end of the range, for a pull of 1 px/s² at the centre. */
const slowed = (range: number) => range - 200 - (range ** 2 - 200 ** 2) / (2 * range);
const ESCAPE = Math.sqrt(2 * PULL * slowed(RANGE));

/** The number at which a run with the gun held ends differently, between one where it is as given and one where it is not. */
function playedEdge(so: number, not: number, ends: (n: number) => boolean): number {
  let [a, b] = [so, not];
  if (!ends(a) || ends(b)) throw new Error('expected an end between the two');
  for (let i = 0; i < 25; i++) {
    const middle = (a + b) / 2;
    if (ends(middle)) a = middle;
    else b = middle;
  }
  return (a + b) / 2;
}
const HELD: readonly Hold[] = [[0, 3600]];
const outcome = (level: Level, holds = HELD): string => simulate(compile(level), holds, { maxTime: 10 }).outcome;

const goesOn = (steps: number) => `some runs may continue after ${steps} steps`;
const turning = (x: number, more: Partial<LevelFile> = {}) =>
  moving(-40, 0, { asteroids: [at(100, 0)], novae: [at(-x, 0, 20)], ...more });

// Tangentially, at the end of a short range: held all the time, she stays.
const tangential = (v: number, more: Partial<LevelFile> = {}) => moving(0, v, { range: 60, asteroids: [at(50, 0)], ...more });
const stays = playedEdge(60, 10, (v) => outcome(tangential(v)) === 'lost');

describe('orbits', () => {
  const cases: Record<string, NearMiss> = {
    'the speed to get out of range': {
      why: (v) => check(away(v), orbits(200)),
      truth: ESCAPE,
      safe: 'above',
      slack: [0.13, 0.15],
      says: goesOn(200),
      grain: 0.005,
    },
    'the speed to get out of range, with recoil': {
      why: (v) => check(away(v, { recoil: true, asteroids: [at(200, 0, 20)] }), orbits(200), { ...PRECISE, maxTime: 60 }),
      truth: ESCAPE,
      safe: 'above',
      slack: [0.19, 0.21],
      says: goesOn(200),
      grain: 0.005,
    },
    'the speed to get out of range across': {
      why: (v) => check(tangential(v), orbits(60)),
      truth: stays,
      safe: 'above',
      slack: [0.2, 3],
      says: goesOn(60),
      grain: 0.05,
    },
    'the pull': {
      why: (pull) => check(away(30, { rules: { pull } }), orbits(60)),
      truth: 30 ** 2 / 2 / slowed(RANGE),
      safe: 'below',
      slack: [1, 8],
      says: goesOn(60),
      reach: 10,
      grain: 0.05,
    },
    'the range': {
      why: (range) => check(away(30, { range }), orbits(200)),
      truth: playedEdge(230, 300, (range) => outcome(away(30, { range })) === 'lost'),
      safe: 'below',
      slack: [0.48, 0.5],
      says: goesOn(200),
      reach: 8,
      grain: 0.005,
    },
    'a nova that she comes to before she can turn back': {
      why: (x) => check(turning(x), orbits(60)),
      truth: playedEdge(50, 90, (x) => outcome(turning(x)) === 'collided'),
      safe: 'below',
      slack: [0, 5],
      says: goesOn(60),
      reach: 8,
      grain: 0.02,
    },
    'the radius of that nova': {
      why: (radius) => check(turning(0, { novae: [at(-90, 0, radius)] }), orbits(60)),
      truth: playedEdge(50, 5, (radius) => outcome(turning(0, { novae: [at(-90, 0, radius)] })) === 'collided'),
      safe: 'above',
      slack: [0, 5],
      says: goesOn(60),
      reach: 8,
      grain: 0.02,
    },
    'a second asteroid whose range takes her up': {
      why: (x) => check(away(40, { asteroids: [at(200, 0), at(-x, 0)] }), orbits(60)),
      truth: 300,
      safe: 'above',
      slack: [0, 4],
      says: goesOn(60),
      reach: 8,
      grain: 0.02,
    },
    'a field that pushes her out': {
      why: (radius) => check(moving(-12, 0, { asteroids: [at(200, 0)], repulsors: [at(30, 0, radius)] }), orbits(90)),
      truth: playedEdge(
        45,
        31,
        (radius) => outcome(moving(-12, 0, { asteroids: [at(200, 0)], repulsors: [at(30, 0, radius)] })) === 'lost',
      ),
      safe: 'above',
      slack: [0.3, 5],
      says: goesOn(90),
      reach: 2,
      grain: 0.05,
    },
    'a black hole beside her way': {
      why: (d) => check(away(40, { blackHole: spot(-20, d) }), orbits(60)),
      truth: 18 + BOX.halfHeight,
      safe: 'above',
      slack: [BOX.halfDiagonal - BOX.halfHeight, BOX.halfDiagonal - BOX.halfHeight + 0.5],
      says: 'she may touch it in step',
      grain: 0.005,
    },
    'a black hole behind an asteroid that she passes': {
      why: (d) => check(moving(200, 30, { range: 100, asteroids: [at(90, 0)], blackHole: spot(150, d) }), orbits(40, 3)),
      truth: playedEdge(
        20,
        90,
        (d) => outcome(moving(200, 30, { range: 100, asteroids: [at(90, 0)], blackHole: spot(150, d) }), []) === 'completed',
      ),
      safe: 'above',
      slack: [0, 16],
      says: 'she may touch it in step',
      reach: 10,
      grain: 0.02,
    },
    'the speed limit': {
      why: (v) => check(away(v), orbits(10)),
      truth: 500,
      safe: 'below',
      slack: [0, 3],
      says: 'she may reach the speed limit',
      grain: 0.1,
    },
    'a wormhole beside her way': {
      why: (d) => check(away(40, { wormholes: [{ ...at(-20, d, 20), toX: 9000, toY: 9000 }] }), orbits(60)),
      truth: 20,
      safe: 'above',
      slack: [0, 0.5],
      says: 'she may enter a wormhole in step',
      grain: 0.01,
    },
  };
  nearMisses(cases);
});
