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

// What a product or a square is at least and at most, of any number from a0 to a1 and any from b0 to b1.

export const leastProduct = (a0: number, a1: number, b0: number, b1: number): number =>
  Math.min(a0 * b0, a0 * b1, a1 * b0, a1 * b1);

export const mostProduct = (a0: number, a1: number, b0: number, b1: number): number =>
  Math.max(a0 * b0, a0 * b1, a1 * b0, a1 * b1);

export const leastSquare = (a0: number, a1: number): number => (a0 > 0 ? a0 * a0 : a1 < 0 ? a1 * a1 : 0);

export const mostSquare = (a0: number, a1: number): number => Math.max(a0 * a0, a1 * a1);

/** Bounds of a vector along two perpendicular axes. */
export class Vector {
  a0 = 0;
  a1 = 0;
  b0 = 0;
  b1 = 0;
  private readonly axes = new Float64Array(2);

  set(a0: number, a1: number, b0: number, b1: number): void {
    this.a0 = a0;
    this.a1 = a1;
    this.b0 = b0;
    this.b1 = b1;
  }

  copy({ a0, a1, b0, b1 }: Vector): void {
    this.set(a0, a1, b0, b1);
  }

  /** The hull of it and another vector. */
  join(a0: number, a1: number, b0: number, b1: number): void {
    if (a0 < this.a0) this.a0 = a0;
    if (a1 > this.a1) this.a1 = a1;
    if (b0 < this.b0) this.b0 = b0;
    if (b1 > this.b1) this.b1 = b1;
  }

  /** The sum of it and another vector. */
  add(a0: number, a1: number, b0: number, b1: number): void {
    this.a0 += a0;
    this.a1 += a1;
    this.b0 += b0;
    this.b1 += b1;
  }

  /** Widens it by a length in any direction. */
  widen(by: number): void {
    this.set(this.a0 - by, this.a1 + by, this.b0 - by, this.b1 + by);
  }

  /** The same vector along axes that are turned by `angle` from those in which it was given. */
  onAxesTurnedBy(angle: number): void {
    cosineAndSine(angle, this.axes, 0);
    const c = this.axes[0];
    const s = this.axes[1];
    const { a0, a1, b0, b1 } = this;
    this.set(
      Math.min(c * a0, c * a1) + Math.min(s * b0, s * b1),
      Math.max(c * a0, c * a1) + Math.max(s * b0, s * b1),
      Math.min(c * b0, c * b1) + Math.min(-s * a0, -s * a1),
      Math.max(c * b0, c * b1) + Math.max(-s * a0, -s * a1),
    );
  }

  /** Along axes that may be turned by at most `angle` either way, at most 1 rad. */
  tilt(angle: number): void {
    const { a0, a1, b0, b1 } = this;
    const cos = 1 - (angle * angle) / 2;
    const a = angle * Math.max(-a0, a1, 0);
    const b = angle * Math.max(-b0, b1, 0);
    this.set(Math.min(a0, a0 * cos) - b, Math.max(a1, a1 * cos) + b, Math.min(b0, b0 * cos) - a, Math.max(b1, b1 * cos) + a);
  }
}
