import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type AccuracyName, WorkBudget } from '../../engine/index.ts';
import type { Hold, Level, LevelFile } from '../../schema/index.ts';
import { proveBy } from '../../solver/index.ts';
import { mixedLevel, type Prover, playLevel, STYLES } from '../attackers/index.ts';
import { describeDeep, expectDeep, itDeep } from '../depth.ts';
import { seeded } from '../scenes/seeded.ts';
import { at, level } from './impossible-levels.ts';
import { type Moment, momentsOf } from './traced/moments.ts';
import { fanSets, firstOutside, orbitSets, pipeSets, type Sets, staysWithin } from './traced/sets.ts';

// What the provers compute is compared with plays here, and the checker is not asked: a set that leaves out a state of play is an
// error of the prover, even if no certificate with it is ever accepted.

const HOLE = { kind: 'blackHole' } as const;

/** Ticks of each play. Sets of later moments are the most likely to have grown until nothing can leave them. */
const TICKS = 240;

/** Random and greedy plays of a level. */
function playsOf(of: Level, accuracy: AccuracyName, seed: number): Moment[][] {
  const random = seeded(seed * 31 + accuracy.length);
  return [0, 1].map((n) => {
    const style = STYLES[(seed + n * 3) % STYLES.length];
    const { holds } = playLevel(of, accuracy, style, random, TICKS);
    return momentsOf(of, accuracy, holds, TICKS);
  });
}

interface Followed {
  readonly accuracies: readonly AccuracyName[];
  /** The sets of a level on one of the grids; null where the prover has none. */
  readonly sets: (of: Level, grid: number) => Sets | null;
}

const FOLLOWED: Record<string, Followed> = {
  doomed: {
    accuracies: ['arcade', 'fast', 'standard', 'precise'],
    sets: (of, n) => fanSets(of, [{ cell: 8, bin: 16, frames: 6 } as const, { cell: 3, bin: 6, frames: 3 } as const][n % 2], 600),
  },
  flowpipe: {
    accuracies: ['fast', 'standard', 'precise'],
    sets: (of, n) => pipeSets(of, { cell: 4, frames: 2, steps: [20, 50][n % 2], turns: 8 }, { sets: 100, parts: 1500 }),
  },
  orbits: {
    accuracies: ['precise'],
    sets: (of, n) =>
      orbitSets(
        of,
        [
          { place: 6, speed: 6, momentum: 1500, frames: 12 },
          { place: 10, speed: 8, momentum: 900, frames: 6 },
        ][n % 2],
        600,
      ),
  },
};

describe('every state of play lies in the sets of the prover', () => {
  it.each(Object.keys(FOLLOWED))('%s, in levels of any style', (name) => {
    const { accuracies, sets } = FOLLOWED[name];
    let looks = 0;
    let closed = 0;
    fc.assert(
      fc.property(fc.nat(1_000_000), (seed) => {
        const of = mixedLevel(seed);
        const computed = sets(of, seed);
        if (computed === null) return;
        if (computed.closed) closed++;
        for (const accuracy of accuracies) {
          for (const moments of playsOf(of, accuracy, seed)) {
            const outside = firstOutside(computed, moments);
            if (outside !== null) expect.fail(`${accuracy}: her state at tick ${outside.tick} lies in no set`);
            looks += Math.min(computed.contain.length, Math.ceil(moments.length / computed.frames));
          }
        }
      }),
      { numRuns: 60 },
    );
    // Otherwise the test would be vacuous.
    expectDeep(looks).toBeGreaterThan(300);
    expectDeep(closed).toBeGreaterThan(5);
  });
});

/** Provers that say where she stays, without sets for single moments. */
const BOUND: readonly Prover[] = ['out-of-range', 'enclosed', 'line-trap', 'dead-end'];

describeDeep('every state of play lies where the proof says that she stays', () => {
  itDeep('in levels of any style, at each accuracy that it covers', () => {
    const looks = Object.fromEntries(BOUND.map((prover) => [prover, 0]));
    fc.assert(
      fc.property(fc.nat(1_000_000), fc.constantFrom('arcade', 'precise'), (seed, asked) => {
        const of = mixedLevel(seed);
        for (const prover of BOUND) {
          const options = { accuracy: asked, maxTime: 60, budget: new WorkBudget(2000) } as const;
          const proof = proveBy(prover, of, HOLE, options);
          for (const accuracy of proof?.covers ?? []) {
            const stays = proof === null ? null : staysWithin(of, proof, accuracy === 'arcade');
            if (stays === null) continue;
            for (const moments of playsOf(of, accuracy, seed)) {
              looks[prover] += moments.length;
              const outside: Moment | undefined = moments.find((now) => !stays(now));
              if (outside !== undefined) expect.fail(`${prover}, ${accuracy}: she has left it at tick ${outside.tick}`);
            }
          }
        }
      }),
      { numRuns: 120 },
    );
    for (const prover of BOUND) expect(looks[prover], prover).toBeGreaterThan(1000);
  });
});

/** A level and a run whose states once lay in no set. */
interface Case {
  readonly file: Partial<LevelFile>;
  readonly holds: readonly Hold[];
  readonly accuracy: AccuracyName;
  readonly sets: (of: Level) => Sets | null;
}

const farAway = { blackHole: { x: 5000, y: 0 }, minerals: [] };

describe('states that once lay in no set', () => {
  const fan = (of: Level) => fanSets(of, { cell: 4, bin: 8, frames: 4 }, 2000);
  const cases: Record<string, Case> = {
    'orbits: a start faster than half the speed limit': {
      file: { ...farAway, astronaut: { x: 0, y: 0, vx: -498.9, vy: -306.5 }, asteroids: [at(202, 70)] },
      holds: [[0, 4]],
      accuracy: 'precise',
      sets: (of) => orbitSets(of, { place: 6, speed: 6, momentum: 1500, frames: 12 }, 1000),
    },
    'orbits: the same under a low speed limit': {
      file: {
        ...farAway,
        astronaut: { x: 0, y: 0, vx: 40, vy: 30 },
        asteroids: [at(-200, 0)],
        rules: { speedLimit: 90 },
      },
      holds: [],
      accuracy: 'precise',
      sets: (of) => orbitSets(of, { place: 6, speed: 6, momentum: 1500, frames: 12 }, 1000),
    },
    'doomed: in frames a wind blows on her velocity a frame later than on her place': {
      file: {
        ...farAway,
        astronaut: { x: 0, y: 0, vx: 30 },
        asteroids: [at(-200, 0)],
        winds: [{ ...at(0, 0, 400), ax: 0, ay: 90 }],
      },
      holds: [],
      accuracy: 'arcade',
      sets: fan,
    },
    'doomed: in frames she has been in a wind for less than a frame': {
      // A step begins half a px behind its rim, where the last frame has not pushed her yet.
      file: {
        ...farAway,
        astronaut: { x: 0, y: 0, vx: 60 },
        asteroids: [at(-200, 0)],
        winds: [{ ...at(303.5, 0, 300), ax: 0, ay: 100 }],
      },
      holds: [],
      accuracy: 'arcade',
      sets: fan,
    },
    'doomed: fixed steps turn recoil, and with it her velocity': {
      file: {
        ...farAway,
        astronaut: { x: 0, y: 0, vy: -80 },
        asteroids: [at(245, 0, 0.5)],
        winds: [{ ...at(0, 0, 800), ax: 0, ay: 100 }],
        recoil: true,
        rules: { recoil: 20, pull: 1 },
      },
      holds: [[0, 200]],
      accuracy: 'fast',
      sets: fan,
    },
  };
  it.each(Object.keys(cases))('%s', (name) => {
    const { file, holds, accuracy, sets } = cases[name];
    const of = level(file);
    const computed = sets(of);
    if (computed === null || computed.contain.length < 2) throw new Error('expected sets');
    expect(firstOutside(computed, momentsOf(of, accuracy, holds, TICKS))).toBeNull();
  });

  it('orbits follows a start faster than half the speed limit as long as she is slower after the first step', () => {
    // She leaves the range within a step, so nothing is left that would have to be slow.
    const of = level({ ...farAway, astronaut: { x: 0, y: 0, vx: -600 }, asteroids: [at(200, 0)] });
    const computed = orbitSets(of, { place: 6, speed: 6, momentum: 1500, frames: 12 }, 1000);
    expect(computed?.closed).toBe(true);
    // the start, and nothing after the first step
    expect(computed?.contain).toHaveLength(2);
  });
});
