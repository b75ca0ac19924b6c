// What a product or a square is at least and at most, of any number from a0 to a1 and any from b0 to b1.

export const leastProduct = (a0: number, a1: number, b0: number, b1: number): number =>
  Math.min(a0 * b0, a0 * b1, a1 * b0, a1 * b1);

export const mostProduct = (a0: number, a1: number, b0: number, b1: number): number =>
  Math.max(a0 * b0, a0 * b1, a1 * b0, a1 * b1);

export const leastSquare = (a0: number, a1: number): number => (a0 > 0 ? a0 * a0 : a1 < 0 ? a1 * a1 : 0);

export const mostSquare = (a0: number, a1: number): number => Math.max(a0 * a0, a1 * a1);
