/** The two-sided 95 % quantile of the normal distribution. */
const Z = 1.959963984540054;

/**
 * Wilson's score interval at 95 % for a share of successes. Unlike the normal approximation it has a sensible width near 0 and
 * 1 (E. B. Wilson, Probable inference, the law of succession, and statistical inference, 1927).
 */
export function wilsonInterval(successes: number, samples: number): { low: number; high: number } {
  if (samples === 0) return { low: 0, high: 1 };
  const p = successes / samples;
  const z2 = (Z * Z) / samples;
  const middle = p + z2 / 2;
  const half = Z * Math.sqrt((p * (1 - p)) / samples + z2 / (4 * samples));
  const low = successes === 0 ? 0 : (middle - half) / (1 + z2);
  const high = successes === samples ? 1 : (middle + half) / (1 + z2);
  return { low: Math.max(0, low), high: Math.min(1, high) };
}
