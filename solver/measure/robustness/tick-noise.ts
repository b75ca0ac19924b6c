import { TICK_RATE } from '../../../engine/index.ts';

/** The largest error of an edge, in standard deviations; a larger one is rarer than 1 in 10^9. */
const REACH = 6.2;

/** 2^32 */
const UINT32 = 4294967296;

/** 1 / sqrt(2 pi) */
const DENSITY = 0.3989422804014327;

/**
 * The standard normal distribution function minus 1/2, computed by its Taylor series: the density times x/1 + x^3/3 + x^5/(3*5)
 * + ... (Abramowitz and Stegun 26.2.11). It uses only + - * /, and so gives the same bits in every JavaScript engine.
 * @param x between -7 and 7, where the error stays below 1e-14
 */
export function normalBeyondHalf(x: number): number {
  let term = x;
  let sum = x;
  for (let n = 3; Math.abs(term) > 1e-18 * Math.abs(sum); n += 2) {
    term *= (x * x) / n;
    sum += term;
  }
  return DENSITY * expMinus((x * x) / 2) * sum;
}

/** Computes e^-x for x from 0 to 30: the series of x / 64, squared six times. */
function expMinus(x: number): number {
  const part = x / 64;
  let term = 1;
  let sum = 1;
  for (let n = 1; n < 24; n++) {
    term *= part / n;
    sum += term;
  }
  let power = 1 / sum;
  for (let i = 0; i < 6; i++) power *= power;
  return power;
}

/** The distribution of an edge's error: the shifts from `-reach` to `reach` ticks and their probabilities. */
export interface TickNoise {
  /** The largest shift, ticks. */
  readonly reach: number;
  /** `probability[shift + reach]`, 0 to 1. */
  readonly probability: Float64Array;
  /** `upTo[shift + reach]`: 2^32 times the probability of this shift or an earlier one. */
  readonly upTo: Float64Array;
}

/**
 * Gaussian timing noise as the game reads it: a player aims at the middle of a tick, and the tick in which the finger comes
 * down counts. A shift of k ticks has the probability of an error between k - 1/2 and k + 1/2 ticks.
 * @param sigma standard deviation, ms
 */
export function tickNoise(sigma: number): TickNoise {
  const ticks = (sigma * TICK_RATE) / 1000;
  const reach = Math.ceil(REACH * ticks);
  const size = 2 * reach + 1;
  const probability = new Float64Array(size);
  const upTo = new Float64Array(size);
  if (reach === 0) probability[0] = 1;
  // Compute half of the distribution and mirror it, so that early and late are exactly alike.
  for (let k = 0; k <= reach && reach > 0; k++) {
    const from = k === 0 ? 0 : normalBeyondHalf((k - 0.5) / ticks);
    const to = k === reach ? 0.5 : normalBeyondHalf((k + 0.5) / ticks);
    const share = k === 0 ? 2 * to : to - from;
    probability[reach + k] = share;
    probability[reach - k] = share;
  }
  let sum = 0;
  for (let i = 0; i < size; i++) {
    sum += probability[i];
    upTo[i] = i === size - 1 ? UINT32 : Math.min(UINT32, sum * UINT32);
  }
  return { reach, probability, upTo };
}

/** Every edge is exactly `ticks` too early or too late: the hardest noise that a certificate of this many ticks covers. */
export function extremeNoise(ticks: number): TickNoise {
  const probability = new Float64Array(2 * ticks + 1);
  probability[0] = 0.5;
  probability[2 * ticks] = 0.5;
  const upTo = new Float64Array(2 * ticks + 1).fill(UINT32 / 2);
  upTo[2 * ticks] = UINT32;
  return { reach: ticks, probability, upTo };
}

/** The shift for a uniform 32-bit number. */
export function drawShift(noise: TickNoise, uint32: number): number {
  const { upTo, reach } = noise;
  let low = 0;
  let high = upTo.length - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (uint32 < upTo[middle]) high = middle;
    else low = middle + 1;
  }
  return low - reach;
}

/**
 * Attempts with this number and above are for choosing among runs, those below for measuring the chosen one, whatever the seed.
 * A share of successes is unbiased only when nothing has been chosen by the same attempts.
 */
export const FIRST_TO_CHOOSE_BY = 1_073_741_824;

/**
 * A uniform 32-bit number that depends only on seed, sample and edge. Attempt n of every run gets the same errors, so that runs
 * are compared under the same noise (common random numbers), whatever their number of edges. The mixing steps are those of
 * MurmurHash3's finalizer (A. Appleby).
 */
export function uniformOf(seed: number, sample: number, edge: number): number {
  let h = mix(seed ^ 0x9e3779b9);
  h = mix(h ^ Math.imul(sample + 1, 0x85ebca6b));
  return mix(h + Math.imul(edge + 1, 0xc2b2ae35)) >>> 0;
}

/**
 * The shift of an edge in an attempt to choose by, ticks. Each attempt is followed by its mirror image (early becomes late), so that
 * noise that happens to lean to one side is not mistaken for room on the other.
 */
export function mirroredShift(noise: TickNoise, seed: number, attempt: number, edge: number): number {
  const late = drawShift(noise, uniformOf(seed, FIRST_TO_CHOOSE_BY + (attempt >> 1), edge));
  return attempt % 2 === 0 ? late : -late;
}

function mix(value: number): number {
  let h = value | 0;
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return h ^ (h >>> 16);
}
