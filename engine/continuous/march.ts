/**
 * How far a guard can be followed safely: the largest t with g + dg t - k t^2 / 2 >= 0 on [0, t].
 * With k no less than -g'' everywhere ahead, g cannot reach 0 before; near a simple root the steps converge to it
 * quadratically from the safe side, past a near miss they stride over it.
 * @param g value of the guard, >= 0
 * @param dg its derivative
 * @param k bound on how fast the derivative can fall, >= 0
 * @returns t >= 0, perhaps Infinity
 */
export function safeStep(g: number, dg: number, k: number): number {
  const root = Math.sqrt(dg * dg + 2 * k * g);
  if (dg < 0) return (2 * g) / (root - dg);
  return k > 0 ? (dg + root) / k : Number.POSITIVE_INFINITY;
}

/**
 * The smallest stride past a guard that touches zero without crossing it, s. What it may overlook is below 1e-18 px deep.
 * @param length natural length of the piece, s
 */
export function smallestStride(length: number): number {
  return Math.min(1e-10, length * 1e-6);
}
