import { TICK } from '../../../engine/index.ts';
import type { Place } from '../../../schema/basics/index.ts';
import { driftAfter } from '../assumptions.ts';
import type { Setting } from '../setting.ts';
import { NUMBERS } from './layer.ts';
import { Rectangle } from './rectangle.ts';
import { type OrbitScene, SLACK } from './scene.ts';
import { atan2, cos, sin } from './trigonometry.ts';

/** Boxes are Cartesian nearer than this, px, or where she may turn about the centre more quickly than this, rad/s. */
const INNER = 16;
const QUICK = 3;

/** States about each of the asteroids: where a box lies between them, and the same states about another one. */
export class Charts {
  readonly rocks: OrbitScene['rocks'];
  /** How far recoil may have carried each asteroid by the end of the step, px. */
  drift: number[];
  /** The places that are asked about. */
  readonly rect = new Rectangle();
  /** What `fill` made. */
  readonly made = new Float64Array(NUMBERS);
  private readonly setting: Setting;
  /** How fast recoil may have made each asteroid by the end of the step, px/s. */
  private shift: number[];
  // what `velocity` found, px/s
  private vx0 = 0;
  private vx1 = 0;
  private vy0 = 0;
  private vy1 = 0;

  constructor(setting: Setting, { rocks }: OrbitScene) {
    this.setting = setting;
    this.rocks = rocks;
    this.drift = rocks.map(() => 0);
    this.shift = rocks.map(() => 0);
  }

  /** Sets the end of the step, s. */
  until(time: number): void {
    this.drift = this.rocks.map((_, i) => driftAfter(this.setting, i, time));
    this.shift = this.rocks.map(({ k }) => k * (time + TICK));
  }

  /** Least distance of a place from the rectangle about asteroid i, px. */
  near(i: number, { x, y }: Place): number {
    return this.rect.near(x - this.rocks[i].x, y - this.rocks[i].y);
  }

  /** Greatest distance of a place from the rectangle about asteroid i, px. */
  far(i: number, { x, y }: Place): number {
    return this.rect.far(x - this.rocks[i].x, y - this.rocks[i].y);
  }

  /** Whether j may be nearer than i somewhere in the rectangle. */
  mayBeNearer(i: number, j: number): boolean {
    const ox = this.rocks[j].x - this.rocks[i].x;
    const oy = this.rocks[j].y - this.rocks[i].y;
    const x = ox * this.rect.ca + oy * this.rect.sa;
    const y = oy * this.rect.ca - ox * this.rect.sa;
    const most = (x > 0 ? x * this.rect.X1 : x * this.rect.X0) + (y > 0 ? y * this.rect.Y1 : y * this.rect.Y0);
    const square = ox * ox + oy * oy;
    const D = this.drift[i] + this.drift[j];
    return most + D * (this.rect.farthest() + Math.sqrt(square)) + SLACK * (1 + Math.sqrt(square)) >= square / 2;
  }

  /** Whether she may come nearer to j faster than to i, so that j may become the nearest within h seconds. */
  mayCross(box: Float64Array, i: number, j: number, isPolar: boolean, h: number): boolean {
    const { rocks, drift, shift } = this;
    const ox = rocks[j].x - rocks[i].x;
    const oy = rocks[j].y - rocks[i].y;
    const o = Math.sqrt(ox * ox + oy * oy);
    this.velocity(box, isPolar, atan2(oy, ox));
    const D = drift[i] + drift[j];
    const V = shift[i] + shift[j];
    const gain = h * (this.setting.strongest + rocks[i].k);
    const speed = Math.max(-this.vx0, this.vx1) + Math.max(-this.vy0, this.vy1) + 2 * gain;
    return o * (this.vx1 + gain) + D * speed + V * (this.rect.farthest() + o + D) + SLACK > 0;
  }

  /** Whether i may be the nearest somewhere in the rectangle. */
  mayBeNearest(i: number): boolean {
    for (let j = 0; j < this.rocks.length; j++) {
      if (j === i) continue;
      const ox = this.rocks[j].x - this.rocks[i].x;
      const oy = this.rocks[j].y - this.rocks[i].y;
      const x = ox * this.rect.ca + oy * this.rect.sa;
      const y = oy * this.rect.ca - ox * this.rect.sa;
      const least = (x > 0 ? x * this.rect.X0 : x * this.rect.X1) + (y > 0 ? y * this.rect.Y0 : y * this.rect.Y1);
      const square = ox * ox + oy * oy;
      const D = this.drift[i] + this.drift[j];
      if (least - D * (this.rect.farthest() + Math.sqrt(square)) - D * D - SLACK * (1 + Math.sqrt(square)) > square / 2)
        return false;
    }
    return true;
  }

  /** Nearer than this, px, boxes with these momenta are Cartesian. */
  border(l0: number, l1: number): number {
    const m = (Math.abs(l0) + Math.abs(l1)) / 2;
    return Math.max(INNER, Math.sqrt(m / QUICK));
  }

  /** Asks about the places of a box. */
  rectOf(box: Float64Array, isPolar: boolean): void {
    if (isPolar) this.rect.sector(box[0], box[1], box[2], box[3]);
    else this.rect.plain(box[0], box[1], box[2], box[3]);
  }

  /** The velocity of a box along axes turned by beta, relative to the box's asteroid. */
  private velocity(box: Float64Array, isPolar: boolean, beta: number): void {
    this.measureVelocity(box, isPolar, beta);
    // Near a centre the quotient of momentum and distance may be far greater than she is fast.
    const fast = Math.sqrt(2 * box[11]) + SLACK;
    this.vx0 = Math.max(this.vx0, -fast);
    this.vx1 = Math.min(this.vx1, fast);
    this.vy0 = Math.max(this.vy0, -fast);
    this.vy1 = Math.min(this.vy1, fast);
  }

  private measureVelocity(box: Float64Array, isPolar: boolean, beta: number): void {
    if (isPolar) {
      const mid = (box[2] + box[3]) / 2;
      const s = sin(Math.min(Math.PI / 2, (box[3] - box[2]) / 2));
      const q = 1 - cos(Math.min(Math.PI, (box[3] - box[2]) / 2));
      const c = cos(mid - beta);
      const t = sin(mid - beta);
      const p0 = box[8] >= 0 ? box[8] / box[1] : box[8] / box[0];
      const p1 = box[9] >= 0 ? box[9] / box[0] : box[9] / box[1];
      const x0 = Math.min(box[4] * c, box[5] * c) - Math.max(p0 * t, p1 * t);
      const x1 = Math.max(box[4] * c, box[5] * c) - Math.min(p0 * t, p1 * t);
      const y0 = Math.min(box[4] * t, box[5] * t) + Math.min(p0 * c, p1 * c);
      const y1 = Math.max(box[4] * t, box[5] * t) + Math.max(p0 * c, p1 * c);
      const xm = Math.max(-x0, x1);
      const ym = Math.max(-y0, y1);
      this.vx0 = x0 - ym * s - xm * q - SLACK;
      this.vx1 = x1 + ym * s + xm * q + SLACK;
      this.vy0 = y0 - xm * s - ym * q - SLACK;
      this.vy1 = y1 + xm * s + ym * q + SLACK;
      return;
    }
    const c = cos(beta);
    const t = sin(beta);
    this.vx0 = Math.min(box[4] * c, box[5] * c) + Math.min(box[6] * t, box[7] * t) - SLACK;
    this.vx1 = Math.max(box[4] * c, box[5] * c) + Math.max(box[6] * t, box[7] * t) + SLACK;
    this.vy0 = Math.min(box[6] * c, box[7] * c) - Math.max(box[4] * t, box[5] * t) - SLACK;
    this.vy1 = Math.max(box[6] * c, box[7] * c) - Math.min(box[4] * t, box[5] * t) + SLACK;
  }

  /** Writes the box as one about asteroid j to `made`; whether it is polar, null when it is empty. */
  fill(box: Float64Array, chart: number, j: number, nearOnly: boolean): boolean | null {
    const { made, rocks } = this;
    const i = chart >> 1;
    const isPolar = chart % 2 === 0;
    this.rectOf(box, isPolar);
    const D = i === j ? SLACK : this.drift[i] + this.drift[j] + SLACK;
    const V = i === j ? 0 : this.shift[i] + this.shift[j];
    const ox = rocks[i].x - rocks[j].x;
    const oy = rocks[i].y - rocks[j].y;
    // The rectangle about j, in its own frame.
    const { alpha, ca, sa } = this.rect;
    const x = ox * ca + oy * sa;
    const y = oy * ca - ox * sa;
    const X0 = this.rect.X0 + x - D;
    const X1 = this.rect.X1 + x + D;
    const Y0 = this.rect.Y0 + y - D;
    const Y1 = this.rect.Y1 + y + D;
    const farY = this.rect.farthest();
    // Momentum
    let l0 = box[8];
    let l1 = box[9];
    if (i !== j) {
      const o = Math.sqrt(ox * ox + oy * oy);
      this.velocity(box, isPolar, atan2(oy, ox));
      const speed = Math.max(-this.vx0, this.vx1) + Math.max(-this.vy0, this.vy1);
      const more = farY * V + (o + D) * V + D * speed + 1e-4;
      l0 += o * this.vy0 - more;
      l1 += o * this.vy1 + more;
    }
    const dx = Math.max(0, X0, -X1);
    const dy = Math.max(0, Y0, -Y1);
    // Energy
    const fast = Math.sqrt(2 * box[11]);
    made[10] = box[10] - V * fast - 1e-4;
    made[11] = box[11] + V * fast + V * V + 1e-4;
    let near = Math.sqrt(dx * dx + dy * dy);
    const fx = Math.max(-X0, X1);
    const fy = Math.max(-Y0, Y1);
    let far = Math.sqrt(fx * fx + fy * fy);
    if (i === j && isPolar) {
      near = box[0];
      far = box[1];
    }
    const border = this.border(l0, l1);
    const mid = (near + far) / 2;
    if (!nearOnly && near > 6 && mid > border) {
      if (near > this.setting.level.range) return null;
      // Direction
      const beta = atan2((Y0 + Y1) / 2, (X0 + X1) / 2);
      const cb = cos(beta);
      const sb = sin(beta);
      let delta = 0;
      for (let n = 0; n < 4; n++) {
        const px = n & 1 ? X1 : X0;
        const py = n & 2 ? Y1 : Y0;
        const along = px * cb + py * sb;
        const across = Math.abs(py * cb - px * sb);
        delta = Math.max(delta, atan2(across, along));
      }
      if (delta < 1.5) {
        this.velocity(box, isPolar, alpha + beta);
        const c = cos(delta);
        const s = sin(delta);
        const ym = Math.max(-this.vy0, this.vy1) + V;
        const vx0 = this.vx0 - V;
        const vx1 = this.vx1 + V;
        made[0] = near;
        made[1] = far;
        made[2] = alpha + beta - delta - 1e-8;
        made[3] = alpha + beta + delta + 1e-8;
        made[4] = Math.min(vx0, vx0 * c) - ym * s;
        made[5] = Math.max(vx1, vx1 * c) + ym * s;
        made[6] = 0;
        made[7] = 0;
        // v tangential = L / d
        const xm = Math.max(-vx0, vx1);
        const p0 = Math.min(this.vy0 - V, (this.vy0 - V) * c) - xm * s;
        const p1 = Math.max(this.vy1 + V, (this.vy1 + V) * c) + xm * s;
        made[8] = Math.max(l0, Math.min(p0 * near, p0 * far) - 1e-4);
        made[9] = Math.min(l1, Math.max(p1 * near, p1 * far) + 1e-4);
        return made[8] <= made[9] ? true : null;
      }
    }
    // Cartesian, along the level's axes.
    const xs = [X0 * ca - Y0 * sa, X1 * ca - Y0 * sa, X0 * ca - Y1 * sa, X1 * ca - Y1 * sa];
    const ys = [X0 * sa + Y0 * ca, X1 * sa + Y0 * ca, X0 * sa + Y1 * ca, X1 * sa + Y1 * ca];
    this.velocity(box, isPolar, 0);
    made[0] = Math.min(...xs);
    made[1] = Math.max(...xs);
    made[2] = Math.min(...ys);
    made[3] = Math.max(...ys);
    made[4] = this.vx0 - V;
    made[5] = this.vx1 + V;
    made[6] = this.vy0 - V;
    made[7] = this.vy1 + V;
    made[8] = l0;
    made[9] = l1;
    return false;
  }
}
