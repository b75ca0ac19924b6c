// Close passes of an asteroid's centre in integer multiples of 2^-192 (BigInt), by Taylor series of order 40: writes
// near-radial.json. Run: node tests/hard-cases/high-precision/near-radial.mjs && npx biome format --write tests/hard-cases/high-precision
import { writeFileSync } from 'node:fs';

const BITS = 192n;
const ONE = 1n << BITS;
const ORDER = 40;
const RANGE = 250;
const PULL = 39;
const FAR = 100;

/** A double as a fixed-point number, exact if it has no digits below 2^-192. */
function fixed(x) {
  let [mantissa, exponent] = [x, 0];
  while (!Number.isInteger(mantissa)) [mantissa, exponent] = [mantissa * 2, exponent + 1];
  return (BigInt(mantissa) << BITS) >> BigInt(exponent);
}

/** The nearest double or one of its neighbours. */
function double(x) {
  const negative = x < 0n;
  const size = negative ? -x : x;
  const drop = Math.max(0, size.toString(2).length - 60);
  const value = Number(size >> BigInt(drop)) * 2 ** (drop - Number(BITS));
  return negative ? -value : value;
}

const times = (a, b) => (a * b) >> BITS;
const over = (a, b) => (a << BITS) / b;

function root(x) {
  const n = x << BITS;
  let r = 1n << BigInt(Math.ceil(n.toString(2).length / 2));
  for (;;) {
    const next = (r + n / r) >> 1n;
    if (next >= r) return r;
    r = next;
  }
}

/**
 * Series of x, y about the centre: u'' = (A / range - A / d) u, with the powers of s = d² by p = s^a: p_n = sum over k of (a k
 * - (n - k)) s_k p_(n-k) / (n s_0).
 */
function series(x0, y0, vx0, vy0) {
  const [x, y, s, p] = [[x0, vx0], [y0, vy0], [], []];
  const [pull, lift] = [fixed(PULL), over(fixed(PULL), fixed(RANGE))];
  const product = (a, b, n) => {
    let sum = 0n;
    for (let k = 0; k <= n; k++) sum += a[k] * b[n - k];
    return sum >> BITS;
  };
  for (let n = 0; n + 2 <= ORDER; n++) {
    s[n] = product(x, x, n) + product(y, y, n);
    if (n === 0) p[0] = over(ONE, root(s[0]));
    else {
      let sum = 0n;
      for (let k = 1; k <= n; k++) sum += BigInt(-k - 2 * (n - k)) * s[k] * p[n - k];
      p[n] = sum / (BigInt(2 * n) * s[0]);
    }
    const divisor = BigInt((n + 1) * (n + 2));
    x[n + 2] = (times(lift, x[n]) - times(pull, product(p, x, n))) / divisor;
    y[n + 2] = (times(lift, y[n]) - times(pull, product(p, y, n))) / divisor;
  }
  return [x, y];
}

/** log2 of a fixed-point number's magnitude, rounded up; the terms of a close pass are too large for doubles. */
const sizeOf = (x) => (x < 0n ? -x : x).toString(2).length - Number(BITS);

/** Step at which the last terms are below 2^-90 px, s. */
function stepOf(x, y) {
  const logs = [ORDER - 1, ORDER].map((k) => (-90 - Math.max(sizeOf(x[k]), sizeOf(y[k]))) / k);
  return 2 ** Math.min(...logs);
}

function run(speed, seconds) {
  let [x, y, vx, vy] = [fixed(-FAR), 0n, 0n, fixed(speed)];
  const samples = [];
  let now = 0n;
  for (let second = 1; second <= seconds; second++) {
    const until = BigInt(second) << BITS;
    while (now < until) {
      const [a, b] = series(x, y, vx, vy);
      const step = stepOf(a, b);
      const h = now + fixed(step) < until ? fixed(step) : until - now;
      const value = (c) => c.reduceRight((sum, term) => times(sum, h) + term, 0n);
      const slope = (c) => value(c.slice(1).map((term, k) => term * BigInt(k + 1)));
      [x, y, vx, vy] = [value(a), value(b), slope(a), slope(b)];
      now += h;
    }
    samples.push([second, double(x) + FAR, double(y), double(vx), double(vy)]);
  }
  return samples;
}

const cases = [1e-1, 1e-3, 1e-5, 1e-7, 1e-9].map((beside) => {
  // the velocity across the line at the farthest point with which she passes the centre at about this distance, at 79 px/s
  const speed = (beside * 79) / FAR;
  return { beside, speed, samples: run(speed, 30) };
});
const file = new URL('near-radial.json', import.meta.url);
const lines = cases.map((c) => `  ${JSON.stringify(c)}`);
writeFileSync(file, `[\n${lines.join(',\n')}\n]\n`);
