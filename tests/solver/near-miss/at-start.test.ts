import { describe, expect, it } from 'vitest';
import { compile, simulate } from '../../../engine/index.ts';
import type { ThingRef } from '../../../solver/index.ts';
import {
  at,
  BOX,
  CONTINUOUS,
  CORNER,
  FRAMES,
  hot,
  levelWith,
  type NearMiss,
  nearMisses,
  RANGE,
  spot,
  whyNot,
} from './near-miss.ts';

const ALL = [...CONTINUOUS, ...FRAMES];
const MINERAL = { kind: 'mineral', index: 0 } as const;
const nowhere = { kind: 'nothing-in-range' } as const;
const starts = (kind: ThingRef['kind'], index = 0) => ({ kind: 'starts-in-hazard', hazard: { kind, index } }) as const;
const RADIUS = 18;
/** Half the diagonal is rounded to 18.868 px; it is 18.86796. */
const ROUNDED_DIAGONAL = [3.78e-5, 3.79e-5] as const;
/** A black hole at this distance towards the box's lower right corner. */
const towardsCorner = (d: number) => spot(CORNER.x * d, CORNER.y * d);

const inRange = (place: (d: number) => ReturnType<typeof at>): NearMiss => ({
  why: (d) => whyNot(levelWith({ asteroids: [at(400, 0), place(d)] }), nowhere, { covers: ALL }),
  truth: RANGE,
  safe: 'above',
  slack: [1e-7, 1.6e-7],
  says: 'asteroid 2 is not farther from the start than the range',
});

describe('nothing-in-range', () => {
  nearMisses({
    'an asteroid to the right': inRange((d) => at(d, 0)),
    'an asteroid above and to the left': inRange((d) => at(-0.6 * d, -0.8 * d)),
    'a black hole that her corner touches': {
      why: (d) => whyNot(levelWith({ blackHole: towardsCorner(d) }), nowhere, { covers: ALL }),
      truth: RADIUS + BOX.halfDiagonal,
      safe: 'above',
      slack: ROUNDED_DIAGONAL,
      says: 'she may touch it at the start',
    },
    'a mineral that her corner touches': {
      why: (d) => whyNot(levelWith({ minerals: [{ ...towardsCorner(-d), radius: 7 }] }), nowhere, { about: MINERAL }),
      truth: 7 + BOX.halfDiagonal,
      safe: 'above',
      slack: ROUNDED_DIAGONAL,
      says: 'she may touch it at the start',
    },
  });
});

it('nothing-in-range: the first asteroid counts like any other', () => {
  expect(whyNot(levelWith({ asteroids: [at(249, 0)] }), nowhere)).toContain('asteroid 1');
  expect(whyNot(levelWith({ asteroids: [at(251, 0)] }), nowhere)).toBeNull();
});

describe('starts-in-hazard', () => {
  const overlaps = (place: (d: number) => ReturnType<typeof at>, truth: number): NearMiss => ({
    why: (d) => whyNot(levelWith({ novae: [at(900, 0), place(d)] }), starts('nova', 1)),
    truth,
    safe: 'below',
    slack: [1e-7, 1.2e-7],
    says: 'the hazard it names does not touch her at the start',
  });
  const overlapsTurned = (place: (d: number) => ReturnType<typeof at>): NearMiss => ({
    why: (d) => whyNot(levelWith({ novae: [place(d)] }), starts('nova'), { covers: ALL }),
    truth: 20 + BOX.halfWidth,
    safe: 'below',
    slack: [1e-7, 1.2e-7],
    says: '',
  });
  nearMisses({
    'a nova to the right': overlaps((d) => at(d, 3, 20), 20 + BOX.halfWidth),
    'a nova to the left': overlaps((d) => at(-d, -9, 20), 20 + BOX.halfWidth),
    'a nova above': overlaps((d) => at(4, -d, 20), 20 + BOX.halfHeight),
    'a nova below': overlaps((d) => at(-9, d, 20), 20 + BOX.halfHeight),
    'a nova at a corner': overlaps((d) => at(-CORNER.x * d, CORNER.y * d, 20), 20 + BOX.halfDiagonal),
    'with frames, a nova below her, whose box may lie across': overlapsTurned((d) => at(0, d, 20)),
    'with frames, a nova aslant': overlapsTurned((d) => at(0.6 * d, 0.8 * d, 20)),
    'with frames, a black hole as near as the nova': {
      why: (d) => whyNot(levelWith({ novae: [at(1, 0)], blackHole: towardsCorner(d) }), starts('nova'), { covers: ALL }),
      truth: RADIUS + BOX.halfDiagonal,
      safe: 'above',
      slack: ROUNDED_DIAGONAL,
      says: 'she may touch it at the start',
    },
    'a mineral as near as the nova': {
      why: (d) =>
        whyNot(levelWith({ novae: [at(1, 0)], minerals: [{ ...towardsCorner(d), radius: 7 }] }), starts('nova'), {
          about: MINERAL,
        }),
      truth: 7 + BOX.halfDiagonal,
      safe: 'above',
      slack: ROUNDED_DIAGONAL,
      says: 'she may touch it at the start',
    },
  });

  it('a box turned by a press is clear of a nova that it would touch upright, and in frames the press comes first: simulated, and therefore refused', () => {
    const level = levelWith({ novae: [at(0, 35, 20)], asteroids: [at(0, -100)], blackHole: spot(0, -140) });
    expect(simulate(compile(level, 'arcade'), [[0, 600]]).outcome).toBe('completed');
    expect(whyNot(level, starts('nova'))).toBeNull();
    expect(whyNot(level, starts('nova'), { covers: FRAMES })).toBe('a box turned by a press may not touch the hazard');
  });

  it('at the start hazards come before the black hole, but not in frames: simulated, and therefore accepted', () => {
    const level = levelWith({ novae: [at(20, 0)], blackHole: spot(-20, 0), asteroids: [at(100, 0)] });
    expect(simulate(compile(level, 'precise'), []).outcome).toBe('collided');
    expect(whyNot(level, starts('nova'))).toBeNull();
    expect(simulate(compile(level, 'arcade'), []).outcome).toBe('completed');
    expect(whyNot(level, starts('nova'), { covers: FRAMES })).toBe('she may touch it at the start');
    expect(whyNot(level, starts('nova'), { covers: ALL })).toBe('she may touch it at the start');
  });

  it('a mineral is collected at the instant in which she dies: simulated, and therefore nothing is accepted', () => {
    const level = levelWith({ novae: [at(20, 0)], minerals: [spot(-15, 0)], asteroids: [at(100, 0)] });
    expect(simulate(compile(level, 'precise'), []).minerals).toHaveLength(1);
    expect(whyNot(level, starts('nova'), { about: MINERAL })).toBe('she may touch it at the start');
  });

  it('which objects are hazards, and which are not', () => {
    const level = levelWith({
      novae: [at(5, 0)],
      aliens: [at(5, 0, 25)],
      asteroids: [at(5, 0), hot(5, 0)],
      blackHole: spot(900, 0),
    });
    expect(whyNot(level, starts('nova'))).toBeNull();
    expect(whyNot(level, starts('alien'))).toBeNull();
    expect(whyNot(level, starts('asteroid', 1))).toBeNull();
    expect(whyNot(level, starts('asteroid', 0))).toBe('the asteroid it names is cold');
    const absent = 'it names a hazard that the level does not have';
    expect(whyNot({ ...level, blackHole: { ...level.blackHole, x: 1005, y: -2000 } }, starts('blackHole'))).toBe(absent);
    for (const index of [1, -1, 0.5, Number.NaN, '0' as never]) expect(whyNot(level, starts('nova', index))).toBe(absent);
    expect(whyNot(level, starts('asteroid', 2))).toBe(absent);
    expect(whyNot(level, { kind: 'starts-in-hazard', hazard: undefined as never })).toBe(absent);
    expect(whyNot(level, starts('repulsor' as never))).toBe(absent);
  });
});
