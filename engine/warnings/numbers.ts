/** A length for people: px with at most three decimals. */
export const px = (length: number): string => `${Math.round(length * 1000) / 1000} px`;

/** Distance between two places, px. */
export const distance = (a: Place, b: Place): number => {
  const dx = a.x - b.x;
  const dy = a.y - b.y;
  return Math.sqrt(dx * dx + dy * dy);
};

export interface Place {
  readonly x: number;
  readonly y: number;
}
