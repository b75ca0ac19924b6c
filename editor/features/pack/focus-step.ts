/** Where something stands on the screen, px. */
export interface Spot {
  readonly left: number;
  readonly top: number;
}

/**
 * The spot that an arrow key leads to in rows of cards: the next or the one before, or the nearest in the row below or above.
 * @returns its index; the same if there is none
 */
export function spotAfter(spots: readonly Spot[], from: number, key: string): number {
  if (key === 'ArrowRight') return Math.min(spots.length - 1, from + 1);
  if (key === 'ArrowLeft') return Math.max(0, from - 1);
  if (key === 'Home') return 0;
  if (key === 'End') return spots.length - 1;
  const here = spots[from];
  if (here === undefined) return from;
  const isDown = key === 'ArrowDown';
  const beyond = spots.map(({ top }) => top).filter((top) => (isDown ? top > here.top + 1 : top < here.top - 1));
  if (beyond.length === 0) return from;
  const row = isDown ? Math.min(...beyond) : Math.max(...beyond);
  let best = from;
  for (const [i, { left, top }] of spots.entries()) {
    if (Math.abs(top - row) > 1) continue;
    if (best === from || Math.abs(left - here.left) < Math.abs(spots[best].left - here.left)) best = i;
  }
  return best;
}
