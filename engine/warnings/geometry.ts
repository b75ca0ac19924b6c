/** A length in words: px with at most three decimals. */
export const px = (length: number): string => `${Math.round(length * 1000) / 1000} px`;

export interface Place {
  readonly x: number;
  readonly y: number;
}

export interface Disc extends Place {
  readonly radius: number;
}

/** Distance between two places, px. */
export function distance(a: Place, b: Place): number {
  const dx = a.x - b.x;
  const dy = a.y - b.y;
  return Math.sqrt(dx * dx + dy * dy);
}

/** Whether the whole of `disc` lies inside `by`, so that touching the one means touching the other. */
export const covers = (by: Disc, disc: Disc): boolean => distance(by, disc) + disc.radius <= by.radius;
