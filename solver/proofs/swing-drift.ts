import type { Rules } from '../../schema/index.ts';
import type { Drift } from './proof.ts';

/** What is added to the least drift that is never reached, a part and px: the checker's bound must come out below it. */
const SPARE = 1.0001;
const SPARE_PX = 0.01;

/** Rounds of a contraction: far more than it needs. */
const MOST_ROUNDS = 400;

/** Where she may be on the line while she swings, px from the start, and where the asteroid is at first. */
export interface SwingStretch {
  readonly centre: number;
  readonly back: number;
  readonly front: number;
}

/**
 * How far recoil can carry an asteroid either way while she swings through it on a line and never leaves a stretch, px.
 *
 * While the gun is held she is accelerated by a = pull (1 - d / range), the asteroid the other way by recoil / diameter. Were a the same
 * everywhere, its speed would be a fixed share of hers and its way the same share of hers, which the stretch bounds: nothing would add up.
 * It gains speed ahead when she is ahead of it, where a is at least some A, and loses it when she is behind, where a is at most the pull. So the
 * share 2 / (A + pull), times recoil / diameter, leaves at most (pull - A) / (pull + A) of its acceleration unaccounted for, and only that adds
 * up, for as long as a run lasts. The other way likewise. The farther it drifts the smaller A may be; a drift from which follows a smaller one
 * is never reached.
 * @param most how far it is carried when it is pulled one way all the time, px
 */
export function swingDrift(
  { pull, recoil }: Rules,
  radius: number,
  range: number,
  { centre, back, front }: SwingStretch,
  seconds: number,
  most: number,
): Drift {
  const follows = (far: number, way: number): number => {
    const weakest = pull * (1 - Math.min(far, range) / range);
    const unpaid = (pull - weakest) / (pull + weakest);
    return Math.min(most, (recoil * 1.01 * ((unpaid * seconds * seconds) / 2 + (2 * way) / (pull + weakest))) / (2 * radius));
  };
  let drift: Drift = { back: 0, ahead: 0 };
  for (let round = 0; round < MOST_ROUNDS; round++) {
    const ahead = follows(front - centre + drift.back, -back);
    const behind = follows(centre + drift.ahead - back, front);
    const isNever = (next: number, bound: number) => next < bound || bound >= most;
    if (isNever(ahead, drift.ahead) && isNever(behind, drift.back)) {
      return { back: Math.min(most, drift.back * SPARE + SPARE_PX), ahead: Math.min(most, drift.ahead * SPARE + SPARE_PX) };
    }
    drift = {
      back: Math.max(drift.back, Math.min(most, 1.0005 * behind + 0.002)),
      ahead: Math.max(drift.ahead, Math.min(most, 1.0005 * ahead + 0.002)),
    };
  }
  return { back: most, ahead: most };
}
