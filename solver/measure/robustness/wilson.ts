/** The two-sided 95 % quantile of the normal distribution. */
const Z_95 = 1.959963984540054;

/** The two-sided 90 % quantile of the normal distribution. */
export const Z_90 = 1.6448536269514722;

/**
 * Wilson's score interval for a share of successes, at 95 % by default. Unlike the normal approximation it has a sensible width near 0 and
 * 1 (E. B. Wilson, Probable inference, the law of succession, and statistical inference, 1927).
 * @param z the two-sided quantile of the normal distribution that belongs to the level of confidence
 */
export function wilsonInterval(successes: number, samples: number, z = Z_95): { low: number; high: number } {
  if (samples === 0) return { low: 0, high: 1 };
  const p = successes / samples;
  const z2 = (z * z) / samples;
  const middle = p + z2 / 2;
  const half = z * Math.sqrt((p * (1 - p)) / samples + z2 / (4 * samples));
  const low = successes === 0 ? 0 : (middle - half) / (1 + z2);
  const high = successes === samples ? 1 : (middle + half) / (1 + z2);
  return { low: Math.max(0, low), high: Math.min(1, high) };
}
