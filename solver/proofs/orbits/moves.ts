import { easySpeed } from '../assumptions.ts';
import { RIM_SLACK } from '../rims.ts';
import type { Setting } from '../setting.ts';
import { mostSquare } from './agree.ts';
import { Charts } from './charts.ts';
import type { OrbitScene } from './scene.ts';
import { SLACK, slackL } from './slack.ts';
import { cos, sin } from './trigonometry.ts';
import type { OrbitWatch } from './watch.ts';

/** Moves boxes through a part of a step. */
export abstract class Moves extends Charts {
  /** Why it gave up; empty when it did not. */
  why = '';
  protected readonly watch: OrbitWatch;
  protected readonly fastest: number;
  /** Length of the part, s. */
  protected h = 0;
  /** Whether `box` has polar coordinates. */
  protected isPolar = false;
  /** Bits of the asteroids that may have become the nearest. */
  protected mark = 0;
  private readonly crowded: boolean;
  // what `forces` found, in the axes of the rectangle, px/s²
  private ax0 = 0;
  private ax1 = 0;
  private ay0 = 0;
  private ay1 = 0;
  private windX0 = 0;
  private windX1 = 0;
  private windY0 = 0;
  private windY1 = 0;
  private inField = false;
  private foreign = false;

  constructor(setting: Setting, scene: OrbitScene, watch: OrbitWatch) {
    super(setting, scene);
    this.watch = watch;
    this.fastest = easySpeed(setting.rules);
    this.crowded = scene.rocks.length > 1 || scene.fields.length > 0 || scene.winds.length > 0;
  }

  /** Whether she may touch what nobody follows. */
  private isClear(i: number): boolean {
    if (this.watch.places !== undefined) this.tellPlaces(i, this.watch.places);
    if (this.near(i, this.scene.goal) - this.drift[i] <= this.scene.goal.r + SLACK) {
      this.why = 'she may come near the object';
      return false;
    }
    for (const mouth of this.scene.mouths) {
      if (this.near(i, mouth) - this.drift[i] <= mouth.r + RIM_SLACK) {
        this.why = 'she may enter a mouth';
        return false;
      }
    }
    return true;
  }

  private tellPlaces(i: number, places: NonNullable<OrbitWatch['places']>): void {
    const { ca, sa, X0, X1, Y0, Y1 } = this.rect;
    const { x, y } = this.rocks[i];
    const D = this.drift[i];
    const x0 = Math.min(X0 * ca, X1 * ca) - Math.max(Y0 * sa, Y1 * sa);
    const x1 = Math.max(X0 * ca, X1 * ca) - Math.min(Y0 * sa, Y1 * sa);
    const y0 = Math.min(X0 * sa, X1 * sa) + Math.min(Y0 * ca, Y1 * ca);
    const y1 = Math.max(X0 * sa, X1 * sa) + Math.max(Y0 * ca, Y1 * ca);
    places(x + x0 - D, x + x1 + D, y + y0 - D, y + y1 + D);
  }

  private include(x0: number, x1: number, y0: number, y1: number): void {
    this.ax0 = Math.min(this.ax0, x0);
    this.ax1 = Math.max(this.ax1, x1);
    this.ay0 = Math.min(this.ay0, y0);
    this.ay1 = Math.max(this.ay1, y1);
  }

  /** The accelerations of everything but the asteroid itself, in the rectangle's frame. */
  private forces(i: number, isPolar: boolean): void {
    const { rocks, drift } = this;
    const { pull, push } = this.setting.rules;
    this.inField = false;
    this.foreign = false;
    this.ax0 = this.ay0 = Number.POSITIVE_INFINITY;
    this.ax1 = this.ay1 = Number.NEGATIVE_INFINITY;
    for (const field of this.scene.fields) {
      const near = this.near(i, field) - drift[i];
      if (near > field.r + SLACK) continue;
      this.foreign = true;
      const far = this.far(i, field) + drift[i];
      if (far < field.r - SLACK) this.inField = true;
      if (near < 1) {
        this.include(-push, push, -push, push);
        continue;
      }
      const rx = field.x - rocks[i].x;
      const ry = field.y - rocks[i].y;
      const x = rx * this.rect.ca + ry * this.rect.sa;
      const y = ry * this.rect.ca - rx * this.rect.sa;
      const g0 = push / far;
      const g1 = push / near;
      const D = drift[i];
      this.include(
        least(this.rect.X0 - x - D, g0, g1),
        greatest(this.rect.X1 - x + D, g0, g1),
        least(this.rect.Y0 - y - D, g0, g1),
        greatest(this.rect.Y1 - y + D, g0, g1),
      );
    }
    if (!this.inField) this.include(0, 0, 0, 0);
    const { range } = this.setting.level;
    for (let j = 0; j < rocks.length; j++) {
      if (j === i || !this.mayBeNearer(i, j) || !((this.mark & (1 << (j & 31))) !== 0 || this.mayCross(i, j, isPolar, this.h)))
        continue;
      this.foreign = true;
      this.mark |= 1 << (j & 31);
      // Inside a field the gun does not act, but the nearest asteroid may change.
      if (this.inField) continue;
      const D = drift[i] + drift[j];
      const near = this.near(i, rocks[j]) - D;
      if (near < 1) {
        this.include(-pull, pull, -pull, pull);
        continue;
      }
      const far = this.far(i, rocks[j]) + D;
      const g0 = Math.max(0, pull * (1 / far - 1 / range));
      const g1 = Math.max(0, pull * (1 / near - 1 / range));
      const rx = rocks[j].x - rocks[i].x;
      const ry = rocks[j].y - rocks[i].y;
      const x = rx * this.rect.ca + ry * this.rect.sa;
      const y = ry * this.rect.ca - rx * this.rect.sa;
      this.include(
        least(x - D - this.rect.X1, g0, g1),
        greatest(x + D - this.rect.X0, g0, g1),
        least(y - D - this.rect.Y1, g0, g1),
        greatest(y + D - this.rect.Y0, g0, g1),
      );
    }
    for (const wind of this.scene.winds) {
      if (this.near(i, wind) - drift[i] > wind.r + RIM_SLACK) continue;
      this.foreign = true;
      const isIn = this.far(i, wind) + drift[i] < wind.r - RIM_SLACK;
      const x = wind.ax * this.rect.ca + wind.ay * this.rect.sa;
      const y = wind.ay * this.rect.ca - wind.ax * this.rect.sa;
      this.windX0 += isIn ? x : Math.min(0, x);
      this.windX1 += isIn ? x : Math.max(0, x);
      this.windY0 += isIn ? y : Math.min(0, y);
      this.windY1 += isIn ? y : Math.max(0, y);
    }
  }
  protected movePolar(i: number): boolean {
    const { box, h, rocks, setting } = this;
    const [d0, d1, t0, t1, w0, w1, , , l0, l1] = box;
    const k = rocks[i].k;
    const { pull } = setting.rules;
    const { range } = setting.level;
    const strongest = setting.strongest;
    const A = strongest + k;
    const lm = Math.max(-l0, l1);
    const wm = Math.max(-w0, w1);
    const v = Math.sqrt(Math.min(wm * wm + (lm / d0) * (lm / d0), 2 * box[11])) + A * h;
    if (v > this.fastest) {
      this.why = 'she may be too fast';
      return false;
    }
    const dl = this.crowded ? h * (d1 + v * h) * strongest : 0;
    const e0 = Math.min(d0, d0 + w0 * h - 0.5 * A * h * h);
    if (e0 < 2) {
      this.toNear(box, i);
      this.isPolar = false;
      return this.moveNear(i);
    }
    let m = lm + dl;
    let c1 = (m * m) / (e0 * e0 * e0);
    const e1 = Math.max(d1, d1 + w1 * h + 0.5 * (c1 + (this.crowded ? strongest : 0)) * h * h);
    const r0 = l0 - dl >= 0 ? (l0 - dl) / (e1 * e1) : (l0 - dl) / (e0 * e0);
    const r1 = l1 + dl >= 0 ? (l1 + dl) / (e0 * e0) : (l1 + dl) / (e1 * e1);
    this.rect.sector(e0, e1, t0 + Math.min(0, r0 * h), t1 + Math.max(0, r1 * h));
    if (!this.isClear(i)) return false;
    this.windX0 = this.windX1 = this.windY0 = this.windY1 = 0;
    let R0 = 0;
    let R1 = 0;
    let T0 = 0;
    let T1 = 0;
    if (this.crowded) this.forces(i, true);
    const isForeign = this.crowded && this.foreign;
    if (isForeign) {
      const c = cos(this.rect.delta);
      const s = sin(this.rect.delta);
      const xm = Math.max(-this.ax0, this.ax1, 0);
      const ym = Math.max(-this.ay0, this.ay1, 0);
      R0 = Math.min(this.ax0, this.ax0 * c) - ym * s;
      R1 = Math.max(this.ax1, this.ax1 * c) + ym * s;
      T0 = Math.min(this.ay0, this.ay0 * c) - xm * s;
      T1 = Math.max(this.ay1, this.ay1 * c) + xm * s;
    }
    // paths
    const a1 = Math.max(0, pull * (1 - e0 / range));
    const lowPull = isForeign ? Math.min(R0, this.inField ? R0 : -a1) - k : -a1 - k;
    let high = isForeign ? Math.max(R1, this.inField ? R1 : 0) : 0;
    let low = lowPull;
    if (isForeign && this.scene.winds.length > 0) {
      const c = cos(this.rect.delta);
      const s = sin(this.rect.delta);
      const xm = Math.max(-this.windX0, this.windX1);
      const ym = Math.max(-this.windY0, this.windY1);
      low += Math.min(this.windX0, this.windX0 * c) - ym * s;
      high += Math.max(this.windX1, this.windX1 * c) + ym * s;
      T0 += Math.min(this.windY0, this.windY0 * c) - xm * s;
      T1 += Math.max(this.windY1, this.windY1 * c) + xm * s;
    }
    // momentum
    let n0 = l0;
    let n1 = l1;
    if (isForeign) {
      n0 += h * Math.min(0, T0 * e1, T0 * e0);
      n1 += h * Math.max(0, T1 * e1, T1 * e0);
      const s = slackL(Math.max(-n0, n1));
      n0 -= s;
      n1 += s;
    }
    m = Math.max(-n0, n1);
    const sq1 = m * m;
    const sq0 = n0 > 0 ? n0 * n0 : n1 < 0 ? n1 * n1 : 0;
    c1 = sq1 / (e0 * e0 * e0);
    const c0 = sq0 / (e1 * e1 * e1);
    const lowEnd = d0 + w0 * h + 0.5 * Math.min(0, c0 + low) * h * h;
    const highEnd = d1 + w1 * h + 0.5 * Math.max(0, c1 + high) * h * h;
    const lo1 = Math.max(lowEnd, e0);
    const hi1 = highEnd;
    const cInt1 = (sq1 * h * (d0 + lo1)) / (2 * d0 * d0 * lo1 * lo1);
    const cInt0 = (sq0 * h * (d1 + hi1)) / (2 * d1 * d1 * hi1 * hi1);
    const inv1 = h / (d0 * lo1);
    const inv0 = h / (d1 * hi1);
    let lowV = h * low;
    if (!isForeign) lowV = -h * (Math.max(0, pull * (1 - (d0 + lo1) / (2 * range))) + k);
    box[0] = d0 + w0 * h + 0.5 * (c0 + low) * h * h - SLACK;
    box[1] = d1 + w1 * h + 0.5 * (c1 + high) * h * h + SLACK;
    box[2] = t0 + (n0 >= 0 ? n0 * inv0 : n0 * inv1) - 1e-8;
    box[3] = t1 + (n1 >= 0 ? n1 * inv1 : n1 * inv0) + 1e-8;
    box[4] = w0 + cInt0 + lowV - SLACK;
    box[5] = w1 + cInt1 + h * high + SLACK;
    box[8] = n0;
    box[9] = n1;
    if (isForeign) {
      const more = h * v * (A + strongest);
      box[10] -= more;
      box[11] += more;
    } else {
      const a = -lowV;
      box[10] -= Math.max(0, a * (w1 + Math.max(0, h * c1))) + 1e-4;
      box[11] += Math.max(0, -a * (w0 + Math.min(0, h * (c0 + low)))) + 1e-4;
    }
    if (box[0] < 2) box[0] = 2;
    return true;
  }

  protected moveNear(i: number): boolean {
    const { box, h, rocks, setting } = this;
    const [x0, x1, y0, y1, u0, u1, v0, v1, l0, l1] = box;
    const k = rocks[i].k;
    const { pull } = setting.rules;
    const { range } = setting.level;
    const A = setting.strongest + k;
    const square = mostSquare(u0, u1) + mostSquare(v0, v1);
    if (Math.min(2 * box[11], square) > this.fastest * this.fastest) {
      this.why = 'she may be too fast';
      return false;
    }
    const bend = 0.5 * A * h * h;
    this.rect.plain(
      Math.min(x0, x0 + h * u0 - bend),
      Math.max(x1, x1 + h * u1 + bend),
      Math.min(y0, y0 + h * v0 - bend),
      Math.max(y1, y1 + h * v1 + bend),
    );
    if (!this.isClear(i)) return false;
    this.windX0 = this.windX1 = this.windY0 = this.windY1 = 0;
    this.forces(i, false);
    let { ax0, ax1, ay0, ay1 } = this;
    const isForeign = this.foreign;
    const { X0, X1, Y0, Y1 } = this.rect;
    const dx = Math.max(0, X0, -X1);
    const dy = Math.max(0, Y0, -Y1);
    const near = Math.sqrt(dx * dx + dy * dy);
    const far = this.rect.farthest();
    const strength = this.inField ? 0 : pull;
    if (near < 0.5) {
      const a = strength + k;
      ax0 = Math.min(ax0, -a);
      ax1 = Math.max(ax1, a);
      ay0 = Math.min(ay0, -a);
      ay1 = Math.max(ay1, a);
    } else {
      const g1 = Math.max(0, strength * (1 / near - 1 / range) + k / near);
      const own = [Math.min(0, -X1 * g1), Math.max(0, -X0 * g1), Math.min(0, -Y1 * g1), Math.max(0, -Y0 * g1)];
      const cap = strength + k;
      for (let n = 0; n < 4; n++) own[n] = Math.max(-cap, Math.min(cap, own[n]));
      if (this.inField) {
        ax0 += own[0];
        ax1 += own[1];
        ay0 += own[2];
        ay1 += own[3];
      } else {
        // The recoil of a field's push acts together with it.
        const more = this.scene.fields.length > 0 && isForeign ? k : 0;
        ax0 = Math.min(ax0 - more, own[0]);
        ax1 = Math.max(ax1 + more, own[1]);
        ay0 = Math.min(ay0 - more, own[2]);
        ay1 = Math.max(ay1 + more, own[3]);
      }
    }
    ax0 += this.windX0;
    ax1 += this.windX1;
    ay0 += this.windY0;
    ay1 += this.windY1;
    let n0 = l0;
    let n1 = l1;
    if (isForeign) {
      const dl = h * far * setting.strongest;
      n0 -= dl;
      n1 += dl;
    }
    const gu = h * A;
    const xu0 = Math.min(X0 * (u0 - gu), X0 * (u1 + gu), X1 * (u0 - gu), X1 * (u1 + gu));
    const xu1 = Math.max(X0 * (u0 - gu), X0 * (u1 + gu), X1 * (u0 - gu), X1 * (u1 + gu));
    const yv0 = Math.min(Y0 * (v0 - gu), Y0 * (v1 + gu), Y1 * (v0 - gu), Y1 * (v1 + gu));
    const yv1 = Math.max(Y0 * (v0 - gu), Y0 * (v1 + gu), Y1 * (v0 - gu), Y1 * (v1 + gu));
    const fastest = Math.sqrt(square) + h * A;
    let gain = h * fastest * (A + (isForeign ? setting.strongest : 0));
    let loss = gain;
    if (!isForeign && near >= 0.5) {
      const g1 = Math.max(0, pull * (1 / near - 1 / range) + k / near);
      loss = Math.min(loss, h * g1 * Math.max(0, xu1 + yv1));
      gain = Math.min(gain, h * g1 * Math.max(0, -xu0 - yv0));
    }
    box[10] -= loss + 1e-4;
    box[11] += gain + 1e-4;
    const half = 0.5 * h * h;
    box[0] = x0 + h * u0 + half * ax0 - SLACK;
    box[1] = x1 + h * u1 + half * ax1 + SLACK;
    box[2] = y0 + h * v0 + half * ay0 - SLACK;
    box[3] = y1 + h * v1 + half * ay1 + SLACK;
    box[4] = u0 + h * ax0 - SLACK;
    box[5] = u1 + h * ax1 + SLACK;
    box[6] = v0 + h * ay0 - SLACK;
    box[7] = v1 + h * ay1 + SLACK;
    box[8] = n0;
    box[9] = n1;
    return true;
  }

  private toNear(box: Float64Array, i: number): void {
    this.fill(box, 2 * i, i, true);
    box.set(this.made);
  }
}

const least = (v: number, g0: number, g1: number): number => Math.min(v * g0, v * g1);
const greatest = (v: number, g0: number, g1: number): number => Math.max(v * g0, v * g1);
