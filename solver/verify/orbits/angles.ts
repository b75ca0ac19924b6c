// Sine, cosine and the angle of a vector to a few units in the last place, from + - * / and roots alone: the functions of `Math`
// differ between JavaScript engines.

const QUARTER = Math.PI / 2;

/** Writes the cosine and the sine of an angle to `out[at]` and `out[at + 1]`. The angle is within some turns of 0, rad. */
export function cosineAndSine(angle: number, out: Float64Array, at: number): void {
  const quarters = Math.round(angle / QUARTER);
  const r = angle - quarters * QUARTER;
  const q = -r * r;
  // r is at most pi / 4, so the first omitted term is below 1e-17
  const cos = 1 + (q / 2) * (1 + (q / 12) * (1 + (q / 30) * (1 + (q / 56) * (1 + (q / 90) * (1 + (q / 132) * (1 + q / 182))))));
  const sin =
    r * (1 + (q / 6) * (1 + (q / 20) * (1 + (q / 42) * (1 + (q / 72) * (1 + (q / 110) * (1 + (q / 156) * (1 + q / 210)))))));
  const odd = quarters & 1;
  const c = odd === 0 ? cos : sin;
  const s = odd === 0 ? sin : cos;
  out[at] = ((quarters + 1) & 2) === 0 ? c : -c;
  out[at + 1] = (quarters & 2) === 0 ? s : -s;
}

/** The angle of a vector, from -pi to pi, rad; 0 for the zero vector. */
export function angleOf(x: number, y: number): number {
  const [ax, ay] = [Math.abs(x), Math.abs(y)];
  if (ax === 0 && ay === 0) return 0;
  const steep = ay > ax;
  const first = inFirstEighth(steep ? ax / ay : ay / ax);
  const above = steep ? QUARTER - first : first;
  const right = x >= 0 ? above : Math.PI - above;
  return y >= 0 ? right : -right;
}

/** The arc tangent of a number from 0 to 1. */
function inFirstEighth(t: number): number {
  // the angle halved twice
  const half = t / (1 + Math.sqrt(1 + t * t));
  const u = half / (1 + Math.sqrt(1 + half * half));
  const q = -u * u;
  let sum = 0;
  for (let n = 23; n >= 1; n -= 2) sum = sum * q + 1 / n;
  return 4 * u * sum;
}
