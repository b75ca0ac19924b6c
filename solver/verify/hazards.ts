import type { Blocker } from '../prove/index.ts';
import type { Claim } from './claim.ts';
import { isIndex, type Point } from './rounded.ts';

/**
 * The circle that a hazard covers at all times, wherever recoil moves it, px from the start; null when the object is no such
 * hazard.
 */
export function standingHazard(
  { level, about, place, drift }: Claim,
  by: Blocker | undefined,
): (Point & { radius: number }) | null {
  if (by?.kind === 'nova' && isIndex(by.index, level.novae)) return place(level.novae[by.index]);
  if (by?.kind === 'asteroid' && isIndex(by.index, level.asteroids) && level.asteroids[by.index].hot) {
    const { x, y, radius } = place(level.asteroids[by.index]);
    return { x, y, radius: radius - drift(by.index) };
  }
  // Touching the black hole ends the run, so on the way to a mineral it blocks like a hazard.
  return by?.kind === 'blackHole' && about.kind === 'mineral' ? place(level.blackHole) : null;
}
