import { describe, expect, it } from 'vitest';
import { compile, simulate } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { continuousNames } from './accuracies.ts';
import { type PlainLevel, plainLevel } from './plain-level.ts';

it.each(continuousNames)('two overlapping sleeping aliens explode at the start, even if others touch then: %s', (accuracy) => {
  const level = plainLevel({
    aliens: [
      // awake, they touch and move into each other
      { x: 100, y: -100, radius: 25 },
      { x: 100, y: -50, radius: 25 },
      { x: -200, y: 0, radius: 25 },
      { x: -200, y: 0, radius: 25 },
    ],
  });
  const run = simulate(compile(level, accuracy), [], { maxTime: 1 });
  const found = run.events.flatMap((event) => (event.type === 'explosion' ? [[event.time, ...event.aliens]] : []));
  expect(found.sort((a, b) => a[1] - b[1])).toEqual([
    [0, 0, 1],
    [0, 2, 3],
  ]);
});

it.each(continuousNames)('they touch the box as it stands, and are gone before a press at tick 0 turns it: %s', (accuracy) => {
  // turned upwards, her long side reaches 16 px to the right; as it stands, 10 px
  const endOf = (x: number, other: number) => {
    const level = plainLevel({
      asteroids: [{ x: 0, y: -150, radius: 16 }],
      aliens: [x, other].map((at) => ({ x: at, y: 0, radius: 13 })),
    });
    const { outcome, time } = simulate(compile(level, accuracy), [[0, 30]], { maxTime: 0.5 });
    return [outcome, time];
  };
  expect(endOf(27, 40)).toEqual(['timeout', 0.5]);
  expect(endOf(20, 40)).toEqual(['collided', 0]);
  // aliens apart do not explode, and the turned box touches the first
  expect(endOf(27, 60)).toEqual(['collided', 0]);
});

describe.each(continuousNames)('aliens that overlap explode before what only touches at the start counts, %s', (accuracy) => {
  const run = (parts: PlainLevel, holds: readonly Hold[]) => {
    const { outcome, with: touched, events } = simulate(compile(plainLevel(parts), accuracy), holds, { maxTime: 0.25 });
    return [outcome, touched, ...events.flatMap((event) => (event.type === 'explosion' ? [event.aliens] : []))];
  };
  const asteroids = [{ x: -50, y: 20, radius: 16 }];

  it.each([[[]], [[[0, 30]]], [[[3, 30]]]] as Hold[][][])('she touches one and moves into it, held in %j', (holds) => {
    const astronaut = { vx: -20 };
    const one = { x: -40, y: 0, radius: 30 };
    const other = { x: -20, y: -2, radius: 10 };
    expect(run({ asteroids, astronaut, aliens: [one, other] }, holds)).toEqual(['timeout', null, [0, 1]]);
    expect(run({ asteroids, astronaut, aliens: [other, one] }, holds)).toEqual(['timeout', null, [0, 1]]);
    // of three that overlap one is left, and she touches it
    const third = { x: -20, y: 12, radius: 10 };
    const left = ['collided', { kind: 'alien', index: 2 }, [0, 1]];
    expect(run({ asteroids, astronaut, aliens: [third, one, other] }, holds)).toEqual(left);
  });

  it('two that only touch do not: the box that a press turns into one of them comes first', () => {
    const aliens = [
      { x: 0, y: 67, radius: 50 },
      { x: -60, y: 67, radius: 10 },
    ];
    expect(run({ asteroids: [{ x: -80, y: 60, radius: 5 }], aliens }, [[0, 15]])).toEqual([
      'collided',
      { kind: 'alien', index: 0 },
    ]);
    expect(run({ asteroids, aliens: aliens.map(({ y, ...at }) => ({ ...at, y: y + 50 })) }, [])).toEqual([
      'timeout',
      null,
      [0, 1],
    ]);
  });
});
