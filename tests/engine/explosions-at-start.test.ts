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
