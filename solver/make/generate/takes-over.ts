import type { Place } from '../../../schema/basics/index.ts';

// Of the distance that she has fallen.
const TAKEN = 0.9;

/** Whether she comes nearer to the second asteroid than to the first, when she falls from rest through the first and beyond it. */
export function takesOver(start: Place, first: Place, second: Place): boolean {
  const [ahead, down] = [first.x - start.x, first.y - start.y];
  const fall = Math.sqrt(ahead * ahead + down * down);
  const [dx, dy] = [second.x - first.x, second.y - first.y];
  const along = (dx * ahead + dy * down) / fall;
  // the places that are as far from both lie on a line across; she meets it so far beyond the first
  return along > 0 && (dx * dx + dy * dy) / (2 * along) < TAKEN * fall;
}
