import { cos, sin } from './trigonometry.ts';

/**
 * A rectangle that contains places about an asteroid, px. It lies along axes that are turned by `alpha` rad: those of a sector
 * of a ring point from the asteroid to its middle.
 */
export class Rectangle {
  alpha = 0;
  /** Cosine and sine of `alpha`. */
  ca = 1;
  sa = 0;
  /** Half the angle of the sector, rad; 0 if it is none. */
  delta = 0;
  X0 = 0;
  X1 = 0;
  Y0 = 0;
  Y1 = 0;

  /** All places at distances from d0 to d1 px in directions from t0 to t1 rad. */
  sector(d0: number, d1: number, t0: number, t1: number): void {
    this.alpha = (t0 + t1) / 2;
    const delta = (t1 - t0) / 2;
    this.delta = delta;
    this.ca = cos(this.alpha);
    this.sa = sin(this.alpha);
    const c = delta < Math.PI ? cos(delta) : -1;
    const s = delta < Math.PI / 2 ? sin(delta) : 1;
    this.X0 = c > 0 ? d0 * c : d1 * c;
    this.X1 = d1;
    this.Y0 = -d1 * s;
    this.Y1 = d1 * s;
  }

  /** All places with x from x0 to x1 and y from y0 to y1. */
  plain(x0: number, x1: number, y0: number, y1: number): void {
    this.alpha = 0;
    this.delta = 0;
    this.ca = 1;
    this.sa = 0;
    this.X0 = x0;
    this.X1 = x1;
    this.Y0 = y0;
    this.Y1 = y1;
  }

  /** Least distance of a place, px. */
  near(rx: number, ry: number): number {
    const x = rx * this.ca + ry * this.sa;
    const y = ry * this.ca - rx * this.sa;
    const dx = Math.max(0, this.X0 - x, x - this.X1);
    const dy = Math.max(0, this.Y0 - y, y - this.Y1);
    return Math.sqrt(dx * dx + dy * dy);
  }

  /** Greatest distance of a place, px. */
  far(rx: number, ry: number): number {
    const x = rx * this.ca + ry * this.sa;
    const y = ry * this.ca - rx * this.sa;
    const dx = Math.max(x - this.X0, this.X1 - x);
    const dy = Math.max(y - this.Y0, this.Y1 - y);
    return Math.sqrt(dx * dx + dy * dy);
  }

  /** Least distance of the asteroid, px. */
  nearest(): number {
    const x = Math.max(0, this.X0, -this.X1);
    const y = Math.max(0, this.Y0, -this.Y1);
    return Math.sqrt(x * x + y * y);
  }

  /** Greatest distance of the asteroid, px. */
  farthest(): number {
    const x = Math.max(-this.X0, this.X1);
    const y = Math.max(-this.Y0, this.Y1);
    return Math.sqrt(x * x + y * y);
  }
}
