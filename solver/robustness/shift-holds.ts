import { joinHolds } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';

/**
 * What the game reads when every edge comes a few ticks earlier (negative) or later: ticks below 0 are 0, a hold whose
 * release doesn't come after its press vanishes, holds that overlap or touch join.
 * @param shifts ticks, two for each hold: press, release
 */
export function shiftHolds(holds: readonly Hold[], shifts: ArrayLike<number>): Hold[] {
  return joinHolds(
    holds.map(([press, release], i): Hold => [Math.max(0, press + shifts[2 * i]), Math.max(0, release + shifts[2 * i + 1])]),
  );
}
