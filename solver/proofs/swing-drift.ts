import { GUN_PULL } from '../../engine/index.ts';

/** What is added to the least drift that is never reached, a part and px: whoever tries other drifts finds one below it, too. */
const SPARE = 1.06;
const SPARE_PX = 0.1;

/** Rounds of a contraction: far more than it needs. */
const MOST_ROUNDS = 100;

/**
 * How far recoil can carry an asteroid while she swings through it on a line and never comes farther than a stretch allows, px.
 *
 * While the gun is held she is accelerated by a = GUN_PULL (1 - d / range), the asteroid the other way by 1 / diameter. Were a the same
 * everywhere, its speed would be a fixed share of hers and its way the same share of hers, which the stretch bounds: nothing would add up.
 * With a between A and GUN_PULL, the share 2 / (A + GUN_PULL) per diameter leaves (GUN_PULL - A) / (GUN_PULL + A) of its acceleration
 * unaccounted for, and only that adds up, for as long as a run lasts. The farther it drifts the smaller A may be; a drift from which follows a
 * smaller one is never reached.
 * @param reach how far she can be from where the asteroid starts, px
 * @param way how far she can be from where she starts, px
 * @returns infinity where there is no such bound
 */
export function swingDrift(radius: number, range: number, reach: number, way: number, seconds: number): number {
  const diameter = 2 * radius;
  let drift = 0;
  for (let round = 0; round < MOST_ROUNDS; round++) {
    const weakest = GUN_PULL * (1 - (reach + drift) / range);
    if (weakest <= 0) return Number.POSITIVE_INFINITY;
    const unpaid = (GUN_PULL - weakest) / (GUN_PULL + weakest);
    const follows = (1.01 * ((unpaid * seconds * seconds) / 2 + (2 * way) / (GUN_PULL + weakest))) / diameter;
    if (follows < drift) return drift * SPARE + SPARE_PX;
    drift = 1.001 * follows + 0.001;
  }
  return Number.POSITIVE_INFINITY;
}
