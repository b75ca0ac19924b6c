import { boxCircleGap } from './contact/index.ts';
import type { Scene } from './scene.ts';
import type { BodyKind } from './simulation.ts';

/** The nearest she came to something deadly: `distance` is the gap between her box and it, px. */
export interface Clearance {
  readonly distance: number;
  readonly kind: BodyKind;
  readonly index: number;
  /** s */
  readonly time: number;
}

/** Follows the smallest gap between her box and any hazard over the states it is shown. */
export class ClearanceTracker {
  best: Clearance | null = null;

  constructor(private readonly scene: Scene) {}

  /**
   * @param aliens x, y, alive of every alien
   * @param asteroids x, y of every asteroid in the level's order
   * @returns the smallest gap in this state, px
   */
  see(time: number, x: number, y: number, cos: number, sin: number, aliens: Float64Array, asteroids: Float64Array): number {
    const { novae, targets, coldCount, aliens: kinds } = this.scene;
    let least = Number.POSITIVE_INFINITY;
    for (let i = 0; i < novae.count; i++) {
      const gap = this.try(time, novae.x[i] - x, novae.y[i] - y, cos, sin, novae.r[i], 'nova', novae.index[i]);
      if (gap < least) least = gap;
    }
    for (let i = coldCount; i < targets.count; i++) {
      const k = targets.index[i];
      const gap = this.try(time, asteroids[2 * k] - x, asteroids[2 * k + 1] - y, cos, sin, targets.r[i], 'asteroid', k);
      if (gap < least) least = gap;
    }
    for (let i = 0; i < kinds.count; i++) {
      if (aliens[3 * i + 2] === 0) continue;
      const gap = this.try(time, aliens[3 * i] - x, aliens[3 * i + 1] - y, cos, sin, kinds.r[i], 'alien', i);
      if (gap < least) least = gap;
    }
    return least;
  }

  private try(time: number, dx: number, dy: number, cos: number, sin: number, r: number, kind: BodyKind, index: number): number {
    const distance = boxCircleGap(dx, dy, cos, sin, r);
    if (this.best === null || distance < this.best.distance) this.best = { distance, kind, index, time };
    return distance;
  }
}
