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

/**
 * The quantile of the standard normal distribution: algorithm PPND7 (M. J. Wichura, Algorithm AS 241, Applied Statistics 37, 1988),
 * right to about 1e-7. Portable: it uses only + - * / and the square root.
 * @param p between 0 and 1, exclusive
 */
export function normalQuantile(p: number): number {
  const q = p - 0.5;
  if (Math.abs(q) <= 0.425) {
    const r = 0.180625 - q * q;
    const above = ((59.10937472 * r + 159.29113202) * r + 50.434271938) * r + 3.3871327179;
    const below = ((67.1875636 * r + 78.757757664) * r + 17.895169469) * r + 1;
    return (q * above) / below;
  }
  const tail = Math.sqrt(-logarithm(q < 0 ? p : 1 - p));
  const value = tail <= 5 ? nearTail(tail - 1.6) : farTail(tail - 5);
  return q < 0 ? -value : value;
}

const nearTail = (r: number): number =>
  (((0.17023821103 * r + 1.3067284816) * r + 2.75681539) * r + 1.4234372777) / ((0.12021132975 * r + 0.7370016425) * r + 1);

const farTail = (r: number): number =>
  (((0.017337203997 * r + 0.42868294337) * r + 3.081226386) * r + 6.657905115) / ((0.012258202635 * r + 0.24197894225) * r + 1);
