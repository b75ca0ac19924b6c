import { cosineAndSine } from './arithmetic.ts';
import type { Body } from './scene.ts';

/** Far more than the rounding error of a square of lengths, relative to the largest of them. */
const OF_SQUARES = 1e-14;

/** From this width on, a sector counts as the whole ring, rad. */
const WIDE = 3;

/**
 * A set of places relative to an asteroid: a sector of a ring around it, or a rectangle. It measures how an object lies towards
 * it. One instance is used again and again, since the checker looks at millions of sets.
 *
 * Vectors are given along two axes. For a sector these point away from the asteroid and along the circle around it, in the
 * sense from x to y; for a rectangle they are x and y.
 */
export class Places {
  /** Whether it is a sector. */
  isSector = true;
  /** Least and greatest distance from the asteroid, px. */
  least = 0;
  most = 0;
  // the rectangle
  x0 = 0;
  x1 = 0;
  y0 = 0;
  y1 = 0;
  private isRing = false;
  private readonly ends = new Float64Array(4);

  // what `look` found
  /** Least and greatest distance between the object and a place, px. */
  near = 0;
  far = 0;
  /** Bounds of the scalar product of a place and the object's place, px². */
  dot0 = 0;
  dot1 = 0;
  /** Bounds of the object's place along both axes, px. */
  along0 = 0;
  along1 = 0;
  aside0 = 0;
  aside1 = 0;

  /** All places at distances from d0 to d1 px and at angles from t0 to t1 rad. */
  sector(d0: number, d1: number, t0: number, t1: number): void {
    this.isSector = true;
    this.least = d0;
    this.most = d1;
    this.isRing = !(t1 - t0 < WIDE);
    if (this.isRing) return;
    cosineAndSine(t0, this.ends, 0);
    cosineAndSine(t1, this.ends, 2);
  }

  /** All places with x from x0 to x1 and y from y0 to y1, px. */
  rectangle(x0: number, x1: number, y0: number, y1: number): void {
    this.isSector = false;
    this.x0 = x0;
    this.x1 = x1;
    this.y0 = y0;
    this.y1 = y1;
    this.least = this.nearestTo(0, 0);
    this.most = this.farthestFrom(0, 0);
  }

  /** Least distance between a place of the rectangle and the place (x, y), px. */
  private nearestTo(x: number, y: number): number {
    const dx = Math.max(0, this.x0 - x, x - this.x1);
    const dy = Math.max(0, this.y0 - y, y - this.y1);
    return Math.sqrt(dx * dx + dy * dy);
  }

  /** Greatest distance between a place of the rectangle and the place (x, y), px. */
  private farthestFrom(x: number, y: number): number {
    const dx = Math.max(x - this.x0, this.x1 - x);
    const dy = Math.max(y - this.y0, this.y1 - y);
    return Math.sqrt(dx * dx + dy * dy);
  }

  /** Whether a disc of this radius around an object cannot contain any of the places. A quick look: false says nothing. */
  areFarFrom({ r }: Body, radius: number): boolean {
    return r - this.most > radius || this.least - r > radius;
  }

  /** Whether all places are farther from an object than this, px. Unless they are far from it, they have looked at it then. */
  areBeyond(body: Body, radius: number): boolean {
    if (this.areFarFrom(body, radius)) return true;
    this.look(body.x, body.y, body.r);
    return this.near > radius;
  }

  /** Whether all places are nearer to an object than this, px. */
  areWithin(body: Body, radius: number): boolean {
    if (this.areFarFrom(body, radius)) return false;
    this.look(body.x, body.y, body.r);
    return this.far < radius;
  }

  /** Measures an object at (x, y), r px from the asteroid. */
  look(x: number, y: number, r: number): void {
    if (this.isSector) this.lookFromSector(x, y, r);
    else this.lookFromRectangle(x, y);
  }

  private lookFromSector(x: number, y: number, r: number): void {
    let a0 = -r;
    let a1 = r;
    let b0 = -r;
    let b1 = r;
    if (!this.isRing) {
      const { ends } = this;
      const c0 = ends[0];
      const s0 = ends[1];
      const c1 = ends[2];
      const s1 = ends[3];
      const slack = 1e-9 * r;
      // along and across at both ends; while the angle grows, the one turns into the other
      const p = x * c0 + y * s0;
      const q = x * c1 + y * s1;
      const u = y * c0 - x * s0;
      const v = y * c1 - x * s1;
      if (!(u >= -slack && v <= slack)) a1 = Math.max(p, q);
      if (!(u <= slack && v >= -slack)) a0 = Math.min(p, q);
      if (!(p <= slack && q >= -slack)) b1 = Math.max(u, v);
      if (!(p >= -slack && q <= slack)) b0 = Math.min(u, v);
    }
    const { least, most } = this;
    const at = Math.max(least, Math.min(most, a1));
    const squares = r * r + most * most;
    const slack = OF_SQUARES * squares;
    this.near = Math.sqrt(Math.max(0, at * at + r * r - 2 * at * a1 - slack));
    const farthest = Math.max(least * least - 2 * least * a0, most * most - 2 * most * a0);
    this.far = Math.sqrt(Math.max(0, farthest + r * r + slack));
    this.dot0 = (a0 >= 0 ? least * a0 : most * a0) - slack;
    this.dot1 = (a1 >= 0 ? most * a1 : least * a1) + slack;
    this.along0 = a0;
    this.along1 = a1;
    this.aside0 = b0;
    this.aside1 = b1;
  }

  private lookFromRectangle(x: number, y: number): void {
    const { x0, x1, y0, y1 } = this;
    this.near = this.nearestTo(x, y);
    this.far = this.farthestFrom(x, y);
    const slack = OF_SQUARES * (x * x + y * y + this.most * this.most);
    this.dot0 = Math.min(x * x0, x * x1) + Math.min(y * y0, y * y1) - slack;
    this.dot1 = Math.max(x * x0, x * x1) + Math.max(y * y0, y * y1) + slack;
    this.along0 = x;
    this.along1 = x;
    this.aside0 = y;
    this.aside1 = y;
  }

  // Bounds of the way from a place to the object that was looked at, along both axes, px.
  get ahead0(): number {
    return this.along0 - (this.isSector ? this.most : this.x1);
  }

  get ahead1(): number {
    return this.along1 - (this.isSector ? this.least : this.x0);
  }

  get beside0(): number {
    return this.isSector ? this.aside0 : this.aside0 - this.y1;
  }

  get beside1(): number {
    return this.isSector ? this.aside1 : this.aside1 - this.y0;
  }
}
