import { describe, expect, it } from 'vitest';
import { type AccuracyName, compile, STATE_SIZE, simulate } from '../../engine/index.ts';
import { DEFAULT_RULES } from '../../schema/index.ts';
import { plainLevel } from '../engine/plain-level.ts';

const RANGE = 250;
const HOUR = 3600;

/**
 * Relative change of energy and angular momentum in an hour that each accuracy stays below. At `precise` 6.5e-14 (energy) and 5.7e-13 (momentum) were
 * measured, the more the nearer the passes.
 */
const BOUNDS: readonly (readonly [AccuracyName, number])[] = [
  ['precise', 1e-12],
  ['standard', 1e-4],
  ['fast', 1e-2],
];

describe.each(BOUNDS)('an hour of one orbit at %s', (accuracy, bound) => {
  it.each([62, 40, 15])('from 100 px with %d px/s across', (across) => {
    const level = plainLevel({ range: RANGE, asteroids: [{ x: 100, y: 0, radius: 16 }], astronaut: { vy: across } });
    const run = simulate(compile(level, accuracy), [[0, 60 * HOUR]], { maxTime: HOUR });
    expect(run.outcome).toBe('timeout');
    const energy0 = (across * across) / 2 + DEFAULT_RULES.pull * (100 - 10_000 / 500);
    const momentum0 = -100 * across;
    const state = new Float64Array(STATE_SIZE);
    let worst = 0;
    for (let t = 1; t <= HOUR; t++) {
      run.trajectory.at(t, state);
      const [x, y, vx, vy] = state;
      const d = Math.hypot(x - 100, y);
      const energy = (vx * vx + vy * vy) / 2 + DEFAULT_RULES.pull * (d - (d * d) / 500);
      const momentum = (x - 100) * vy - y * vx;
      worst = Math.max(worst, Math.abs(energy / energy0 - 1), Math.abs(momentum / momentum0 - 1));
    }
    expect(worst).toBeLessThanOrEqual(bound);
  });
});
