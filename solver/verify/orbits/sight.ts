import { angleOf, cosineAndSine } from './arithmetic.ts';
import { Places } from './places.ts';
import type { Body } from './scene.ts';

/** Far more than the rounding error of an angle, rad. */
const OF_ANGLE = 1e-9;

/** A wider set of directions counts as all of them, rad. */
const WIDE = 3;

/** Where an asteroid sees a set of places: bounds of distance, px, and of angle, rad. */
export class Sight {
  d0 = 0;
  d1 = 0;
  t0 = 0;
  t1 = 0;
  private readonly places = new Places();
  private readonly axes = new Float64Array(4);
  private base = 0;
  private ux = 0;
  private uy = 0;

  /** The sector with these bounds in the chart of another asteroid, from which the one that sees it lies at `from`. */
  ofSector(d0: number, d1: number, t0: number, t1: number, from: Body, blur: number): void {
    const { places, axes } = this;
    places.sector(d0, d1, t0, t1);
    places.look(from.x, from.y, from.r);
    this.d0 = Math.max(0, places.near - blur);
    this.d1 = places.far + blur;
    const middle = (t0 + t1) / 2;
    cosineAndSine(t0, axes, 0);
    cosineAndSine(t1, axes, 2);
    const [c0, s0, c1, s1] = axes;
    cosineAndSine(middle, axes, 0);
    const [cm, sm] = axes;
    // The sector lies between its corners and the point where the tangents at the outer ones meet.
    const tip = d1 / (c0 * cm + s0 * sm);
    this.begin(tip * cm - from.x, tip * sm - from.y);
    this.add(d0 * c0 - from.x, d0 * s0 - from.y);
    this.add(d0 * c1 - from.x, d0 * s1 - from.y);
    this.add(d1 * c0 - from.x, d1 * s0 - from.y);
    this.add(d1 * c1 - from.x, d1 * s1 - from.y);
    this.end(blur);
  }

  /** A rectangle in x and y. */
  ofRectangle(x0: number, x1: number, y0: number, y1: number): void {
    const { places } = this;
    places.rectangle(x0, x1, y0, y1);
    this.d0 = places.least;
    this.d1 = places.most;
    this.begin((x0 + x1) / 2, (y0 + y1) / 2);
    this.add(x0, y0);
    this.add(x0, y1);
    this.add(x1, y0);
    this.add(x1, y1);
    this.end(0);
  }

  private begin(x: number, y: number): void {
    this.base = angleOf(x, y);
    this.ux = x;
    this.uy = y;
    this.t0 = 0;
    this.t1 = 0;
  }

  private add(x: number, y: number): void {
    const angle = angleOf(x * this.ux + y * this.uy, y * this.ux - x * this.uy);
    if (angle < this.t0) this.t0 = angle;
    if (angle > this.t1) this.t1 = angle;
  }

  /** Seen from within, the corners are all around. */
  private end(blur: number): void {
    const share = blur / this.d0;
    const isAround = !(share < 0.5 && this.t1 - this.t0 < WIDE);
    // the arc sine of at most 1/2 is less than 1.05 times that
    const more = isAround ? 0 : 1.05 * share + OF_ANGLE;
    this.t0 = this.base + (isAround ? -Math.PI : this.t0 - more);
    this.t1 = this.base + (isAround ? Math.PI : this.t1 + more);
  }
}
