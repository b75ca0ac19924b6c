import { joinHolds } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';

/**
 * What the game reads when every edge is shifted: ticks below 0 become 0, holds whose release does not come after their press
 * vanish, and holds that overlap or touch join.
 * @param shifts ticks, negative for earlier; two per hold: press, release
 */
export function shiftHolds(holds: readonly Hold[], shifts: ArrayLike<number>): Hold[] {
  return joinHolds(
    holds.map(([press, release], i): Hold => [Math.max(0, press + shifts[2 * i]), Math.max(0, release + shifts[2 * i + 1])]),
  );
}
