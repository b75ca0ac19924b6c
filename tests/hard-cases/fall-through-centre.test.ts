import { describe, expect, it } from 'vitest';
import { compile, simulate } from '../../engine/index.ts';
import { type Level, NO_OBJECTS } from '../../schema/index.ts';
import { fallen } from './fall.ts';

const RANGE = 250;
const SECONDS = 10;

const level = (d0: number, sideways: number): Level => ({
  name: 'fall',
  description: '',
  astronaut: { x: 0, y: 0, vx: 0, vy: sideways },
  blackHole: { x: 0, y: 9000, radius: 18 },
  range: RANGE,
  recoil: false,
  ...NO_OBJECTS,
  asteroids: [{ id: null, x: d0, y: 0, radius: 16, hot: false }],
  runs: [],
});

/** px; the allowed error of each accuracy in 10 s */
const BOUNDS = [
  ['precise', 1e-9],
  ['standard', 1e-6],
  ['fast', 1e-1],
] as const;

describe.each(BOUNDS)('fall through the centre at %s', (accuracy, bound) => {
  // so little sideways that the path is straight to all digits, but enough to pass beside the centre
  it.each(
    [5, 20, 60, 100, 200].flatMap((d0) => [0, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10].map((sideways) => [d0, sideways] as const)),
  )('from %d px, with %d px/s sideways', (d0, sideways) => {
    const { x } = simulate(compile(level(d0, sideways), accuracy), [[0, 60 * SECONDS]], { maxTime: SECONDS }).final;
    expect(Math.abs(x - fallen(d0, RANGE, SECONDS))).toBeLessThanOrEqual(bound);
  });
});
