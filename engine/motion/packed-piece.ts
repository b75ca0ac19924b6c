import type { Motion } from './motion.ts';
import { HEAD, SLOTS } from './state.ts';

const { DEGREE, MOVES } = SLOTS;

/**
 * Copies the part of the state that describes her on a piece: the slots at its head, and as many coefficients as the piece has.
 */
export function packPiece(m: Motion): Float64Array {
  const { s, ux, uy, px, py } = m;
  const length = s[DEGREE] + 1;
  const series = m.recoil ? [ux, uy, px, py] : [ux, uy];
  const packed = new Float64Array(HEAD + length * series.length);
  packed.set(s.subarray(0, HEAD));
  for (const [k, c] of series.entries()) packed.set(c.subarray(0, length), HEAD + length * k);
  return packed;
}

/** Restores to the state what {@link packPiece} copied. */
export function unpackPiece(m: Motion, packed: Float64Array): void {
  const { s, ux, uy, px, py } = m;
  s.set(packed.subarray(0, HEAD));
  const length = s[DEGREE] + 1;
  const series = s[MOVES] === 1 ? [ux, uy, px, py] : [ux, uy];
  for (const [k, c] of series.entries()) c.set(packed.subarray(HEAD + length * k, HEAD + length * (k + 1)));
}
