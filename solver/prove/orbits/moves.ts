import { RIM_SLACK, type Setting } from '../setting.ts';
import type { Charts } from './charts.ts';
import type { Forces } from './forces.ts';
import { mostSquare, NUMBERS, type OrbitWatch } from './layer.ts';
import { type OrbitScene, SLACK, slackL } from './scene.ts';
import { cos, sin } from './trigonometry.ts';

/** Moves a box through parts of a step. */
export class Moves {
  /** The box that is moved. */
  readonly box = new Float64Array(NUMBERS);
  /** Whether it has polar coordinates. */
  isPolar = false;
  /** Up to this speed she can be followed in the present step, px/s. */
  fastest = 0;
  private readonly setting: Setting;
  private readonly scene: OrbitScene;
  private readonly charts: Charts;
  private readonly forces: Forces;
  private readonly watch: OrbitWatch;
  private readonly crowded: boolean;

  constructor(setting: Setting, scene: OrbitScene, charts: Charts, forces: Forces, watch: OrbitWatch) {
    this.setting = setting;
    this.scene = scene;
    this.charts = charts;
    this.forces = forces;
    this.watch = watch;
    this.crowded = scene.rocks.length > 1 || scene.fields.length > 0 || scene.winds.length > 0;
  }

  /**
   * Moves the box, which is about asteroid i, through h seconds.
   * @returns why it gave up; null when it did not
   */
  part(i: number, h: number): string | null {
    return this.isPolar ? this.movePolar(i, h) : this.moveNear(i, h);
  }

  /** Whether she may touch what nobody follows: why it gives up, or null. */
  private whyNotClear(i: number): string | null {
    const { charts, scene } = this;
    if (this.watch.places !== undefined) this.tellPlaces(i, this.watch.places);
    if (charts.near(i, scene.goal) - charts.drift[i] <= scene.goal.r + SLACK) return 'she may come near the object';
    for (const mouth of scene.mouths) {
      if (charts.near(i, mouth) - charts.drift[i] <= mouth.r + RIM_SLACK) return 'she may enter a mouth';
    }
    return null;
  }

  private tellPlaces(i: number, places: NonNullable<OrbitWatch['places']>): void {
    const { rect, rocks, drift } = this.charts;
    const { ca, sa, X0, X1, Y0, Y1 } = rect;
    const { x, y } = rocks[i];
    const D = drift[i];
    const x0 = Math.min(X0 * ca, X1 * ca) - Math.max(Y0 * sa, Y1 * sa);
    const x1 = Math.max(X0 * ca, X1 * ca) - Math.min(Y0 * sa, Y1 * sa);
    const y0 = Math.min(X0 * sa, X1 * sa) + Math.min(Y0 * ca, Y1 * ca);
    const y1 = Math.max(X0 * sa, X1 * sa) + Math.max(Y0 * ca, Y1 * ca);
    places(x + x0 - D, x + x1 + D, y + y0 - D, y + y1 + D);
  }

  private movePolar(i: number, h: number): string | null {
    const { box, charts, forces, setting } = this;
    const { rect, rocks } = charts;
    const [d0, d1, t0, t1, w0, w1, , , l0, l1] = box;
    const k = rocks[i].k;
    const { pull } = setting.rules;
    const { range } = setting.level;
    const strongest = setting.strongest;
    const A = strongest + k;
    const lm = Math.max(-l0, l1);
    const wm = Math.max(-w0, w1);
    const v = Math.sqrt(Math.min(wm * wm + (lm / d0) * (lm / d0), 2 * box[11])) + A * h;
    if (v > this.fastest) return 'she may be too fast';
    const dl = this.crowded ? h * (d1 + v * h) * strongest : 0;
    const e0 = Math.min(d0, d0 + w0 * h - 0.5 * A * h * h);
    if (e0 < 2) {
      charts.fill(box, 2 * i, i, true);
      box.set(charts.made);
      this.isPolar = false;
      return this.moveNear(i, h);
    }
    let m = lm + dl;
    let c1 = (m * m) / (e0 * e0 * e0);
    const e1 = Math.max(d1, d1 + w1 * h + 0.5 * (c1 + (this.crowded ? strongest : 0)) * h * h);
    const r0 = l0 - dl >= 0 ? (l0 - dl) / (e1 * e1) : (l0 - dl) / (e0 * e0);
    const r1 = l1 + dl >= 0 ? (l1 + dl) / (e0 * e0) : (l1 + dl) / (e1 * e1);
    rect.sector(e0, e1, t0 + Math.min(0, r0 * h), t1 + Math.max(0, r1 * h));
    const why = this.whyNotClear(i);
    if (why !== null) return why;
    let R0 = 0;
    let R1 = 0;
    let T0 = 0;
    let T1 = 0;
    if (this.crowded) forces.look(i, box, true, h);
    const isForeign = this.crowded && forces.foreign;
    if (isForeign) {
      const c = cos(rect.delta);
      const s = sin(rect.delta);
      const xm = Math.max(-forces.ax0, forces.ax1, 0);
      const ym = Math.max(-forces.ay0, forces.ay1, 0);
      R0 = Math.min(forces.ax0, forces.ax0 * c) - ym * s;
      R1 = Math.max(forces.ax1, forces.ax1 * c) + ym * s;
      T0 = Math.min(forces.ay0, forces.ay0 * c) - xm * s;
      T1 = Math.max(forces.ay1, forces.ay1 * c) + xm * s;
    }
    // paths
    const a1 = Math.max(0, pull * (1 - e0 / range));
    const lowPull = isForeign ? Math.min(R0, forces.inField ? R0 : -a1) - k : -a1 - k;
    let high = isForeign ? Math.max(R1, forces.inField ? R1 : 0) : 0;
    let low = lowPull;
    if (isForeign && this.scene.winds.length > 0) {
      const c = cos(rect.delta);
      const s = sin(rect.delta);
      const xm = Math.max(-forces.windX0, forces.windX1);
      const ym = Math.max(-forces.windY0, forces.windY1);
      low += Math.min(forces.windX0, forces.windX0 * c) - ym * s;
      high += Math.max(forces.windX1, forces.windX1 * c) + ym * s;
      T0 += Math.min(forces.windY0, forces.windY0 * c) - xm * s;
      T1 += Math.max(forces.windY1, forces.windY1 * c) + xm * s;
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
    return null;
  }

  private moveNear(i: number, h: number): string | null {
    const { box, charts, forces, setting } = this;
    const { rect, rocks } = charts;
    const [x0, x1, y0, y1, u0, u1, v0, v1, l0, l1] = box;
    const k = rocks[i].k;
    const { pull } = setting.rules;
    const { range } = setting.level;
    const A = setting.strongest + k;
    const square = mostSquare(u0, u1) + mostSquare(v0, v1);
    if (Math.min(2 * box[11], square) > this.fastest * this.fastest) return 'she may be too fast';
    const bend = 0.5 * A * h * h;
    rect.plain(
      Math.min(x0, x0 + h * u0 - bend),
      Math.max(x1, x1 + h * u1 + bend),
      Math.min(y0, y0 + h * v0 - bend),
      Math.max(y1, y1 + h * v1 + bend),
    );
    const why = this.whyNotClear(i);
    if (why !== null) return why;
    forces.look(i, box, false, h);
    let { ax0, ax1, ay0, ay1 } = forces;
    const isForeign = forces.foreign;
    const { X0, X1, Y0, Y1 } = rect;
    const dx = Math.max(0, X0, -X1);
    const dy = Math.max(0, Y0, -Y1);
    const near = Math.sqrt(dx * dx + dy * dy);
    const far = rect.farthest();
    const strength = forces.inField ? 0 : pull;
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
      if (forces.inField) {
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
    ax0 += forces.windX0;
    ax1 += forces.windX1;
    ay0 += forces.windY0;
    ay1 += forces.windY1;
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
    return null;
  }
}
