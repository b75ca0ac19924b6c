import type { Claim } from './claim.ts';
import { apart, isIndex, less } from './rounded.ts';

const START = { x: 0, y: 0 };

/**
 * The asteroids listed are all that she can ever be in range of: no other is in range of the start, and none is so near to
 * one of them that she could pass from range to range. None of them is near enough to the thing.
 */
export function checkOutOfRange(claim: Claim, listed: readonly number[]): string | null {
  const { asteroids, range } = claim.level;
  if (!Array.isArray(listed) || !listed.every((i) => isIndex(i, asteroids)))
    return 'it lists asteroids that the level does not have';
  // out of range of all, she would be lost at the start, but what she touches in that instant comes first
  if (!less(claim.touch, apart(claim.thing, START))) return 'she may touch it at the start';
  const inside = new Set(listed);
  const place = asteroids.map(claim.place);
  for (const [i, a] of place.entries()) {
    if (inside.has(i)) {
      const reach = range + claim.drift(i) + claim.touch;
      if (!less(reach, apart(a, claim.thing))) return `she may touch it in range of asteroids[${i}]`;
      continue;
    }
    if (!less(range + claim.drift(i), apart(a, START))) return `asteroids[${i}] is in range of the start and not listed`;
    for (const j of inside) {
      const gap = 2 * range + claim.drift(i) + claim.drift(j) + claim.jump;
      if (!less(gap, apart(a, place[j]))) return `asteroids[${i}] is not listed, and she may come to it from asteroids[${j}]`;
    }
  }
  return null;
}
