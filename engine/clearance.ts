import { boxCircleGap } from './contact/index.ts';
import type { Scene } from './scene.ts';
import type { BodyKind } from './simulation.ts';

/**
 * The nearest she came to something deadly: `distance` is the gap between her box and it, px. In continuous time she was there
 * at `time`, and never nearer by more than 1e-6 px; in `arcade` it is the least gap at any frame.
 */
export interface Clearance {
  readonly distance: number;
  readonly kind: BodyKind;
  readonly index: number;
  /** s */
  readonly time: number;
}

/** Follows the smallest gap between her box and any hazard. */
export class ClearanceTracker {
  best: Clearance | null = null;

  constructor(private readonly scene: Scene) {}

  /** The smallest gap so far, px; Infinity before the first. */
  get least(): number {
    return this.best === null ? Number.POSITIVE_INFINITY : this.best.distance;
  }

  /**
   * Looks at a state.
   * @param aliens x, y, alive of every alien
   * @param asteroids x, y of every asteroid in the level's order
   */
  see(time: number, x: number, y: number, cos: number, sin: number, aliens: Float64Array, asteroids: Float64Array): void {
    const { box, novae, targets, coldCount, aliens: kinds } = this.scene;
    for (let i = 0; i < novae.count; i++) {
      this.take(time, boxCircleGap(box, novae.x[i] - x, novae.y[i] - y, cos, sin, novae.r[i]), 'nova', novae.index[i]);
    }
    for (let i = coldCount; i < targets.count; i++) {
      const k = targets.index[i];
      this.take(time, boxCircleGap(box, asteroids[2 * k] - x, asteroids[2 * k + 1] - y, cos, sin, targets.r[i]), 'asteroid', k);
    }
    for (let i = 0; i < kinds.count; i++) {
      if (aliens[3 * i + 2] === 0) continue;
      this.take(time, boxCircleGap(box, aliens[3 * i] - x, aliens[3 * i + 1] - y, cos, sin, kinds.r[i]), 'alien', i);
    }
  }

  /** Takes a gap if it is the smallest so far. */
  take(time: number, distance: number, kind: BodyKind, index: number): void {
    if (distance < this.least) this.best = { distance, kind, index, time };
  }
}
