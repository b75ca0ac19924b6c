import { DEFAULT_RULES } from '../../schema/index.ts';

/**
 * The distance fallen after `t` s from rest at distance d0, px: d(t) = M - (M - d0) cosh(t sqrt(A / M)) down to the centre,
 * mirrored beyond it, and repeated after four times as long.
 * @param range M, px
 */
export function fallen(d0: number, range: number, t: number): number {
  const rate = Math.sqrt(DEFAULT_RULES.pull / range);
  const quarter = Math.acosh(range / (range - d0)) / rate;
  const phase = t % (4 * quarter);
  const fromApex = Math.min(phase, 4 * quarter - phase);
  const distance = (s: number) => range - (range - d0) * Math.cosh(s * rate);
  return fromApex <= quarter ? d0 - distance(fromApex) : d0 + distance(2 * quarter - fromApex);
}
