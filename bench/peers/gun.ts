import { DEFAULT_RULES, type Level } from '../../schema/index.ts';

/**
 * The gun's rule for engines without one of their own: a loop over the asteroids in each step. Acceleration in px/s²; while the
 * gun pulls, `cos`, `sin` and `angle` (radians) are the direction in which the box turns.
 */
export class Gun {
  ax = 0;
  ay = 0;
  angle = 0;
  lost = false;
  private readonly x: Float64Array;
  private readonly y: Float64Array;
  private readonly range: number;

  constructor(level: Level) {
    // the order in which ties are broken
    const targets = [...level.asteroids.filter((a) => !a.hot), ...level.asteroids.filter((a) => a.hot)];
    this.x = Float64Array.from(targets, (a) => a.x);
    this.y = Float64Array.from(targets, (a) => a.y);
    this.range = level.range;
  }

  /** Aims from (x, y), px; sets `ax`, `ay` to the acceleration by the gun. */
  aim(x: number, y: number, held: boolean): void {
    let best = Number.POSITIVE_INFINITY;
    let nearest = 0;
    for (let i = 0; i < this.x.length; i++) {
      const dx = this.x[i] - x;
      const dy = this.y[i] - y;
      const d = dx * dx + dy * dy;
      if (d < best) {
        best = d;
        nearest = i;
      }
    }
    if (best > this.range * this.range) this.lost = true;
    this.ax = 0;
    this.ay = 0;
    if (!held || best === 0) return;
    const d = Math.sqrt(best);
    const pull = DEFAULT_RULES.pull * (1 - d / this.range);
    this.ax = (pull * (this.x[nearest] - x)) / d;
    this.ay = (pull * (this.y[nearest] - y)) / d;
    this.angle = Math.atan2(this.y[nearest] - y, this.x[nearest] - x);
  }
}
