import { expect, it } from 'vitest';
import { compile, simulate } from '../../engine/index.ts';
import { continuousNames } from './accuracies.ts';
import { plainLevel } from './plain-level.ts';

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
