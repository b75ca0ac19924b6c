/** ln 2, and the same in two parts whose first has few bits, so that its multiples are exact. */
const LN2_HIGH = 0.6931471803691238;
const LN2_LOW = 1.9082149292705877e-10;

/**
 * Computes e^x from its Taylor series, after dividing powers of 2 out. It uses only + - * /, and so gives the same bits in every
 * JavaScript engine, which `Math.exp` does not promise.
 * @param x between -700 and 700; the relative error is below 1e-14
 */
export function exponential(x: number): number {
  const twos = Math.round(x / (LN2_HIGH + LN2_LOW));
  const rest = x - twos * LN2_HIGH - twos * LN2_LOW;
  let term = 1;
  let sum = 1;
  for (let n = 1; Math.abs(term) > 1e-17; n++) {
    term *= rest / n;
    sum += term;
  }
  const factor = twos < 0 ? 0.5 : 2;
  for (let i = Math.abs(twos); i > 0; i--) sum *= factor;
  return sum;
}

/**
 * Computes the natural logarithm: powers of 2 are divided out, and the series 2 (t + t^3/3 + t^5/5 + ...) with t = (m - 1) / (m +
 * 1) gives the rest. Portable like {@link exponential}.
 * @param x above 0; the absolute error is below 1e-14 for numbers between 1e-300 and 1e300
 */
export function logarithm(x: number): number {
  let mantissa = x;
  let twos = 0;
  for (; mantissa > 1.5; twos++) mantissa /= 2;
  for (; mantissa < 0.75; twos--) mantissa *= 2;
  const t = (mantissa - 1) / (mantissa + 1);
  let power = t;
  let sum = t;
  for (let n = 3; Math.abs(power) > 1e-17 * n; n += 2) {
    power *= t * t;
    sum += power / n;
  }
  return twos * LN2_HIGH + (twos * LN2_LOW + 2 * sum);
}
