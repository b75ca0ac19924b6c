/** px; the precision of these computations is far below that of doubles in a level. */
const SHIFT = 140n;

/** A double times 2^140, truncated to an integer. */
function whole(x: number): bigint {
  const bits = new DataView(new ArrayBuffer(8));
  bits.setFloat64(0, x);
  const high = bits.getUint32(0);
  const exponent = (high >>> 20) & 0x7ff;
  const fraction = (BigInt(high & 0xfffff) << 32n) | BigInt(bits.getUint32(4));
  const mantissa = exponent === 0 ? fraction : fraction | (1n << 52n);
  const shift = BigInt(Math.max(exponent, 1) - 1075) + SHIFT;
  const size = shift >= 0n ? mantissa << shift : mantissa >> -shift;
  return high >>> 31 === 1 ? -size : size;
}

type Point = readonly [x: number, y: number];

/** The distance of `p` from the line through `a` and `b`, px; in integers, so that no rounding looks like a distance. */
export function offLine(a: Point, b: Point, p: Point): number {
  const [ax, ay, bx, by, px, py] = [...a, ...b, ...p].map(whole);
  const cross = (bx - ax) * (py - ay) - (by - ay) * (px - ax);
  return Number(cross) / 2 ** 280 / Math.hypot(b[0] - a[0], b[1] - a[1]);
}
