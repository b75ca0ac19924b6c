import type { Rules } from '../../schema/basics/index.ts';
import type { Drift } from './proof.ts';

/**
 * What is added to the least drift that is never reached, a factor and px, so that the checker's own bound comes out below it.
 */
const SPARE = 1.0001;
const SPARE_PX = 0.01;

/** Rounds of the contraction; it needs far fewer. */
const MOST_ROUNDS = 400;

/** Where she may be on the line while she swings, px from the start, and where the asteroid is at first. */
export interface SwingStretch {
  readonly centre: number;
  readonly back: number;
  readonly front: number;
}

/**
 * Bounds how far recoil can carry an asteroid either way while she swings through it on a line and never leaves a stretch, px
 * (lemma `swing drift`).
 *
 * While the gun is held, she is accelerated by a = pull (1 - d / range), and the asteroid by recoil / diameter in the opposite
 * direction. If a were constant, the asteroid's speed would be a fixed share of hers, and its path the same share of hers,
 * which the stretch bounds: nothing would accumulate.
 *
 * But a varies. The asteroid gains speed forward when she is ahead of it, where a is at least some A; it loses speed when she
 * is behind, where a is at most the pull. So a share of 2 / (A + pull), times recoil / diameter, explains all but the fraction
 * (pull - A) / (pull + A) of its acceleration. Only this fraction accumulates, for as long as a run lasts. The other direction
 * is alike. The farther the asteroid drifts, the smaller A may be, so the bound is a fixed point: a drift from which a smaller
 * one follows is never reached.
 * @param most the drift if the asteroid were pulled in one direction all the time, px
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
