import { describe, expect, it } from 'vitest';
import { type AccuracyName, compile, STATE_SIZE, simulate } from '../../engine/index.ts';
import { DEFAULT_RULES } from '../../schema/index.ts';
import { isHunt } from '../depth.ts';
import { plainLevel } from '../engine/plain-level.ts';

const RANGE = 250;

/**
 * How long she circles, in s, and the allowed relative change of energy and angular momentum. In an hour at `precise`, 6.5e-14
 * (energy) and 5.7e-13 (momentum) were measured; the closer the passes, the larger the change. With fixed steps the error grows
 * in proportion to the time, so five minutes show it: 8.3e-9 at `standard` and 5.1e-5 at `fast`.
 */
const BOUNDS: readonly (readonly [AccuracyName, number, number])[] = [
  ['precise', 3600, 1e-12],
  ...(isHunt
    ? ([
        ['standard', 3600, 1e-4],
        ['fast', 3600, 1e-2],
      ] as const)
    : ([
        ['standard', 300, 1e-7],
        ['fast', 300, 5e-4],
      ] as const)),
];

describe.each(BOUNDS)('one orbit at %s, for %d s', (accuracy, seconds, bound) => {
  it.each([62, 40, 15])('from 100 px with %d px/s across', (across) => {
    const level = plainLevel({ range: RANGE, asteroids: [{ x: 100, y: 0, radius: 16 }], astronaut: { vy: across } });
    const run = simulate(compile(level, accuracy), [[0, 60 * seconds]], { maxTime: seconds });
    expect(run.outcome).toBe('timeout');
    const energy0 = (across * across) / 2 + DEFAULT_RULES.pull * (100 - 10_000 / 500);
    const momentum0 = -100 * across;
    const state = new Float64Array(STATE_SIZE);
    let worst = 0;
    for (let t = 1; t <= seconds; t++) {
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
