import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { speedAfter } from '../../../solver/verify/assumptions.ts';
import { type Fall, offLine } from '../../../solver/verify/fall.ts';
import { real } from '../../real.ts';
import { PULL, TICK } from './near-miss.ts';

/** The largest relative error of rounding to a double. */
const UNIT = 2 ** -53;

/**
 * The same bound frame by frame: in each frame rounding adds the most that it can to her place (a product, a sum), to her
 * velocity and to the pull, always on the same side, and the angular momentum about the centre turns her off the line.
 */
function frameByFrame(fall: Fall): { beside: number; slope: number } {
  const { centre, nearest, jump, coordinate, speed, seconds, rockSpeed, drift } = fall;
  const bodies = rockSpeed > 0 ? 2 : 1;
  const frames = Math.round(seconds / TICK);
  const fastest = speed + rockSpeed;
  const place = Math.SQRT2 * bodies * UNIT * (coordinate + drift + jump);
  const velocity = bodies * UNIT * (Math.SQRT2 * speed + 6 * PULL * TICK);
  let [momentum, slope] = [0, 0];
  for (let n = 0; n < frames; n++) {
    // She waits as near as possible, where all of it counts most.
    momentum += place * fastest + velocity * centre;
    slope += (TICK * momentum) / (nearest * nearest) + place / nearest;
  }
  const beside = (centre + drift) * slope;
  // At this distance beside the line, she may be as near as that.
  return { beside, slope: slope + beside / nearest };
}

describe('how far rounding takes her off the line on which she falls', () => {
  const falls = fc.record({
    centre: real(40, 250),
    nearest: real(12, 40),
    jump: real(0.1, 3),
    coordinate: real(200, 3000),
    push: fc.constant(PULL),
    speed: real(40, 200),
    seconds: real(5, 80),
    rockSpeed: fc.oneof(fc.constant(0), real(1, 50)),
    drift: real(0, 500),
  });

  it('is between 1 and 35 times what adds up frame by frame', () => {
    fc.assert(
      fc.property(falls, (fall) => {
        const bound = offLine(fall);
        const summed = frameByFrame(fall);
        for (const ratio of [bound.beside / summed.beside, bound.slope / summed.slope]) {
          expect(ratio).toBeGreaterThan(10);
          expect(ratio).toBeLessThan(35);
        }
      }),
      { numRuns: 2000 },
    );
  });

  it('is not bounded where she may jump to within a pixel of the centre', () => {
    const fall = { centre: 100, jump: 3, coordinate: 100, push: PULL, speed: 100, seconds: 10, rockSpeed: 0, drift: 0 };
    const none = { beside: Number.POSITIVE_INFINITY, slope: Number.POSITIVE_INFINITY };
    expect(offLine({ ...fall, nearest: 3.999 })).toEqual(none);
    expect(offLine({ ...fall, nearest: Number.NaN })).toEqual(none);
    expect(offLine({ ...fall, nearest: 4 }).beside).toBeLessThan(1e-3);
    // The asteroid moves towards her by 0.1 px per frame.
    expect(offLine({ ...fall, nearest: 4.099, rockSpeed: 6 })).toEqual(none);
    expect(offLine({ ...fall, nearest: 4.101, rockSpeed: 6 }).beside).toBeLessThan(1e-3);
  });
});

it('no more speed than a constant pull gives, from rest', () => {
  for (const far of [0, 1, 78, 250]) {
    // v² = 2 a s
    expect(speedAfter(PULL, far) ** 2 / (2 * PULL)).toBeCloseTo(far, 10);
  }
});
