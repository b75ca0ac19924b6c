import { cosineAndSine } from './angles.ts';

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
