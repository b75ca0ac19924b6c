import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { type AccuracyName, compile, STATE_SIZE, simulate } from '../../engine/index.ts';
import { plainLevel } from '../engine/plain-level.ts';

interface NearRadial {
  /** the approximate distance from the centre, px */
  readonly beside: number;
  /** px/s across at 100 px */
  readonly speed: number;
  readonly samples: readonly [t: number, x: number, y: number, vx: number, vy: number][];
}

const file = new URL('./high-precision/near-radial.json', import.meta.url);
const cases: NearRadial[] = JSON.parse(readFileSync(file, 'utf8'));

/** px and px/s; the allowed error of each accuracy in a second */
const BOUNDS: readonly (readonly [AccuracyName, number])[] = [
  ['precise', 1e-9],
  ['standard', 1e-3],
  ['fast', 0.5],
];

describe.each(BOUNDS)('close passes against 192-bit arithmetic: %s', (accuracy, bound) => {
  it.each(cases)('$beside px beside the centre', ({ speed, samples }) => {
    const level = plainLevel({ range: 250, asteroids: [{ x: 100, y: 0, radius: 16 }], astronaut: { vy: speed } });
    const { trajectory } = simulate(compile(level, accuracy), [[0, 1800]], { maxTime: 30 });
    const state = new Float64Array(STATE_SIZE);
    let worst = 0;
    for (const [t, ...wanted] of samples) {
      trajectory.at(t, state);
      for (const [i, value] of wanted.entries()) worst = Math.max(worst, Math.abs(state[i] - value) / t);
    }
    expect(worst).toBeLessThanOrEqual(bound);
  });
});
