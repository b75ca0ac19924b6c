import { TICK } from '../../../engine/index.ts';
import type { Blocker, OrbitGrid } from '../proof.ts';
import type { Setting } from '../setting.ts';
import type { Charts } from './charts.ts';
import { agree, type Layer, leastSquare, mostSquare, NUMBERS } from './layer.ts';
import { type OrbitScene, SLACK } from './scene.ts';

const OFF_GRID = 'a box is off the grid';

/** Divides boxes along the grid, leaves out what has ended, and puts the rest into layers. */
export class Cells {
  readonly endedBy = new Set<Blocker>();
  private readonly setting: Setting;
  private readonly scene: OrbitScene;
  private readonly charts: Charts;
  private readonly grid: OrbitGrid;
  private readonly turns: number;
  private readonly turn: number;
  private readonly radix: readonly number[];
  private readonly part = new Float64Array(NUMBERS);

  /** @param fastest the greatest speed, px/s */
  constructor(setting: Setting, scene: OrbitScene, charts: Charts, grid: OrbitGrid, fastest: number) {
    this.setting = setting;
    this.scene = scene;
    this.charts = charts;
    this.grid = grid;
    this.turns = Math.max(4, Math.round((2 * Math.PI * 100) / grid.place));
    this.turn = (2 * Math.PI) / this.turns;
    const reach = setting.level.range + fastest * grid.frames * TICK;
    const cells = 2 * Math.ceil(reach / grid.place) + 4;
    const speeds = 2 * Math.ceil(fastest / grid.speed) + 4;
    const momenta = 2 * Math.ceil((1.5 * reach * fastest) / grid.momentum) + 4;
    this.radix = [cells, Math.max(cells, this.turns), speeds, speeds, momenta];
  }

  /** Whether every cell has a number of its own. */
  fits(): boolean {
    return this.radix.reduce((a, b) => a * b, 2 * this.scene.rocks.length) < Number.MAX_SAFE_INTEGER;
  }

  /** Whether she is dead at all places of the rectangle, none of which is farther than d1 px from asteroid i. */
  private isDead(i: number, d1: number): boolean {
    const { charts, scene } = this;
    const own = scene.own[i];
    if (own !== null && d1 < scene.rocks[i].radius + this.setting.leastHalf - SLACK) {
      this.endedBy.add(own);
      return true;
    }
    for (const hazard of scene.hazards) {
      if (charts.far(i, hazard) + charts.drift[i] >= hazard.r - SLACK) continue;
      this.endedBy.add(hazard.of);
      return true;
    }
    return false;
  }

  /**
   * Puts a box in polar coordinates about asteroid i into the cells of a layer.
   * @param final whether parts are left out for which another asteroid is certainly nearer
   * @returns why it gave up; null when it did not
   */
  polar(layer: Layer, i: number, box: Float64Array, mark: number, final: boolean): string | null {
    const { charts, part, turn, turns, grid, radix } = this;
    const { place, speed, momentum } = grid;
    const a1 = Math.floor(box[1] / place);
    const b1 = Math.floor(box[3] / turn);
    const c0 = Math.floor(box[4] / speed);
    const c1 = Math.floor(box[5] / speed);
    const l0 = Math.floor(box[8] / momentum);
    const l1 = Math.floor(box[9] / momentum);
    if (
      c0 + radix[2] / 2 < 0 ||
      c1 + radix[2] / 2 >= radix[2] ||
      l0 + radix[4] / 2 < 0 ||
      l1 + radix[4] / 2 >= radix[4] ||
      a1 >= radix[0]
    ) {
      return OFF_GRID;
    }
    for (let a = Math.max(0, Math.floor(box[0] / place)); a <= a1; a++) {
      const d0 = Math.max(box[0], a * place);
      const d1 = Math.min(box[1], (a + 1) * place);
      for (let b = Math.floor(box[2] / turn); b <= b1; b++) {
        const t0 = Math.max(box[2], b * turn);
        const t1 = Math.min(box[3], (b + 1) * turn);
        charts.rect.sector(d0, d1, t0, t1);
        this.setting.budget.look((2 + this.scene.hazards.length) / 8 + ((c1 - c0 + 1) * (l1 - l0 + 1)) / 4);
        if (this.isDead(i, d1) || (final && !charts.mayBeNearest(i))) continue;
        const whole = Math.floor(b / turns);
        const back = whole * 2 * Math.PI;
        const bb = b - whole * turns;
        for (let c = c0; c <= c1; c++) {
          for (let l = l0; l <= l1; l++) {
            part[0] = d0;
            part[1] = d1;
            part[2] = t0 - back;
            part[3] = t1 - back;
            part[4] = Math.max(box[4], c * speed);
            part[5] = Math.min(box[5], (c + 1) * speed);
            part[6] = 0;
            part[7] = 0;
            part[8] = Math.max(box[8], l * momentum);
            part[9] = Math.min(box[9], (l + 1) * momentum);
            part[10] = box[10];
            part[11] = box[11];
            if (!agree(part)) continue;
            const key =
              (((2 * i * radix[0] + a) * radix[1] + bb) * radix[2] + c + radix[2] / 2) * radix[3] * radix[4] + l + radix[4] / 2;
            layer.join(key, 2 * i, mark, part);
          }
        }
      }
    }
    return null;
  }

  /** The same for a box in Cartesian coordinates. */
  near(layer: Layer, i: number, box: Float64Array, mark: number, final: boolean): string | null {
    const { charts, part, grid, radix } = this;
    const { place, speed } = grid;
    const ra = radix[0] / 2;
    const rb = Math.floor(radix[1] / 2);
    const rc = radix[2] / 2;
    const a1 = Math.floor(box[1] / place);
    const b1 = Math.floor(box[3] / place);
    const c1 = Math.floor(box[5] / speed);
    const e1 = Math.floor(box[7] / speed);
    const first = [
      Math.floor(box[0] / place),
      Math.floor(box[2] / place),
      Math.floor(box[4] / speed),
      Math.floor(box[6] / speed),
    ];
    if (first[0] < -ra || first[1] < -rb || first[2] < -rc || first[3] < -rc || a1 >= ra || b1 >= rb || c1 >= rc || e1 >= rc) {
      return OFF_GRID;
    }
    for (let a = first[0]; a <= a1; a++) {
      const x0 = Math.max(box[0], a * place);
      const x1 = Math.min(box[1], (a + 1) * place);
      for (let b = first[1]; b <= b1; b++) {
        const y0 = Math.max(box[2], b * place);
        const y1 = Math.min(box[3], (b + 1) * place);
        charts.rect.plain(x0, x1, y0, y1);
        this.setting.budget.look((2 + this.scene.hazards.length) / 8 + ((c1 - first[2] + 1) * (e1 - first[3] + 1)) / 2);
        if (this.isDead(i, charts.rect.farthest()) || (final && !charts.mayBeNearest(i))) continue;
        for (let c = first[2]; c <= c1; c++) {
          const u0 = Math.max(box[4], c * speed);
          const u1 = Math.min(box[5], (c + 1) * speed);
          for (let e = first[3]; e <= e1; e++) {
            const v0 = Math.max(box[6], e * speed);
            const v1 = Math.min(box[7], (e + 1) * speed);
            // L = x v - y u
            const p0 = Math.min(x0 * v0, x0 * v1, x1 * v0, x1 * v1) - Math.max(y0 * u0, y0 * u1, y1 * u0, y1 * u1) - 1e-4;
            const p1 = Math.max(x0 * v0, x0 * v1, x1 * v0, x1 * v1) - Math.min(y0 * u0, y0 * u1, y1 * u0, y1 * u1) + 1e-4;
            const l0 = Math.max(box[8], p0);
            const l1 = Math.min(box[9], p1);
            if (l0 > l1) continue;
            part[0] = x0;
            part[1] = x1;
            part[2] = y0;
            part[3] = y1;
            part[4] = u0;
            part[5] = u1;
            part[6] = v0;
            part[7] = v1;
            part[8] = l0;
            part[9] = l1;
            part[10] = Math.max(box[10], (leastSquare(u0, u1) + leastSquare(v0, v1)) / 2 - 1e-4);
            part[11] = Math.min(box[11], (mostSquare(u0, u1) + mostSquare(v0, v1)) / 2 + 1e-4);
            if (part[10] > part[11]) continue;
            const key = ((((2 * i + 1) * radix[0] + a + ra) * radix[1] + b + rb) * radix[2] + c + rc) * radix[3] + e + rc;
            layer.join(key * radix[4], 2 * i + 1, mark, part);
          }
        }
      }
    }
    return null;
  }
}
