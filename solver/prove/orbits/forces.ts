import { RIM_SLACK, type Setting } from '../setting.ts';
import type { Charts } from './charts.ts';
import { type OrbitScene, SLACK } from './scene.ts';

/** The accelerations of everything but the asteroid itself, in the frame of the chart's rectangle. */
export class Forces {
  /** Bits of the asteroids that may have become the nearest since they were cleared. */
  mark = 0;
  /** Whether a field certainly acts, so that no gun does. */
  inField = false;
  /** Whether anything may act but the asteroid itself. */
  foreign = false;
  // bounds of all but winds, px/s²
  ax0 = 0;
  ax1 = 0;
  ay0 = 0;
  ay1 = 0;
  // bounds of what winds add to that, px/s²
  windX0 = 0;
  windX1 = 0;
  windY0 = 0;
  windY1 = 0;
  private readonly setting: Setting;
  private readonly scene: OrbitScene;
  private readonly charts: Charts;

  constructor(setting: Setting, scene: OrbitScene, charts: Charts) {
    this.setting = setting;
    this.scene = scene;
    this.charts = charts;
  }

  private include(x0: number, x1: number, y0: number, y1: number): void {
    this.ax0 = Math.min(this.ax0, x0);
    this.ax1 = Math.max(this.ax1, x1);
    this.ay0 = Math.min(this.ay0, y0);
    this.ay1 = Math.max(this.ay1, y1);
  }

  /** Looks at the rectangle of asteroid i, with the states of a box, for h seconds. */
  look(i: number, box: Float64Array, isPolar: boolean, h: number): void {
    const { charts } = this;
    const { rocks, drift, rect } = charts;
    this.windX0 = this.windX1 = this.windY0 = this.windY1 = 0;
    const { pull, push } = this.setting.rules;
    this.inField = false;
    this.foreign = false;
    this.ax0 = this.ay0 = Number.POSITIVE_INFINITY;
    this.ax1 = this.ay1 = Number.NEGATIVE_INFINITY;
    for (const field of this.scene.fields) {
      const near = charts.near(i, field) - drift[i];
      if (near > field.r + SLACK) continue;
      this.foreign = true;
      const far = charts.far(i, field) + drift[i];
      if (far < field.r - SLACK) this.inField = true;
      if (near < 1) {
        this.include(-push, push, -push, push);
        continue;
      }
      const rx = field.x - rocks[i].x;
      const ry = field.y - rocks[i].y;
      const x = rx * rect.ca + ry * rect.sa;
      const y = ry * rect.ca - rx * rect.sa;
      const g0 = push / far;
      const g1 = push / near;
      const D = drift[i];
      this.include(
        least(rect.X0 - x - D, g0, g1),
        greatest(rect.X1 - x + D, g0, g1),
        least(rect.Y0 - y - D, g0, g1),
        greatest(rect.Y1 - y + D, g0, g1),
      );
    }
    if (!this.inField) this.include(0, 0, 0, 0);
    const { range } = this.setting.level;
    for (let j = 0; j < rocks.length; j++) {
      if (
        j === i ||
        !charts.mayBeNearer(i, j) ||
        !((this.mark & (1 << (j & 31))) !== 0 || charts.mayCross(box, i, j, isPolar, h))
      )
        continue;
      this.foreign = true;
      this.mark |= 1 << (j & 31);
      // Inside a field the gun does not act, but the nearest asteroid may change.
      if (this.inField) continue;
      const D = drift[i] + drift[j];
      const near = charts.near(i, rocks[j]) - D;
      if (near < 1) {
        this.include(-pull, pull, -pull, pull);
        continue;
      }
      const far = charts.far(i, rocks[j]) + D;
      const g0 = Math.max(0, pull * (1 / far - 1 / range));
      const g1 = Math.max(0, pull * (1 / near - 1 / range));
      const rx = rocks[j].x - rocks[i].x;
      const ry = rocks[j].y - rocks[i].y;
      const x = rx * rect.ca + ry * rect.sa;
      const y = ry * rect.ca - rx * rect.sa;
      this.include(
        least(x - D - rect.X1, g0, g1),
        greatest(x + D - rect.X0, g0, g1),
        least(y - D - rect.Y1, g0, g1),
        greatest(y + D - rect.Y0, g0, g1),
      );
    }
    for (const wind of this.scene.winds) {
      if (charts.near(i, wind) - drift[i] > wind.r + RIM_SLACK) continue;
      this.foreign = true;
      const isIn = charts.far(i, wind) + drift[i] < wind.r - RIM_SLACK;
      const x = wind.ax * rect.ca + wind.ay * rect.sa;
      const y = wind.ay * rect.ca - wind.ax * rect.sa;
      this.windX0 += isIn ? x : Math.min(0, x);
      this.windX1 += isIn ? x : Math.max(0, x);
      this.windY0 += isIn ? y : Math.min(0, y);
      this.windY1 += isIn ? y : Math.max(0, y);
    }
  }
}

const least = (v: number, g0: number, g1: number): number => Math.min(v * g0, v * g1);
const greatest = (v: number, g0: number, g1: number): number => Math.max(v * g0, v * g1);
