import { boxCircleGap } from './contact/index.ts';
import type { Scene } from './scene.ts';
import type { BodyKind } from './simulation.ts';

/**
 * The least distance between her collision box and a hazard during a run. In continuous time `distance` is at most 1e-6 px
 * above the true minimum; under `arcade` it is the least distance at any frame.
 */
export interface Clearance {
  /** Distance from her collision box to the hazard's edge at `time`, px. Negative where they overlap. */
  readonly distance: number;
  /** The kind of the hazard. */
  readonly kind: BodyKind;
  /** Index within the level's own list of that kind, from 0. */
  readonly index: number;
  /** When she was there, s from the start. */
  readonly time: number;
}

/** Keeps the smallest gap between her box and any hazard. */
export class ClearanceTracker {
  best: Clearance | null = null;

  constructor(private readonly scene: Scene) {}

  /** The smallest gap so far, px; Infinity before the first. */
  get least(): number {
    return this.best === null ? Number.POSITIVE_INFINITY : this.best.distance;
  }

  /**
   * Takes one state into account: time in s, her place in px, the box's direction as a unit vector.
   * @param aliens - x, y, alive of every alien
   * @param asteroids - x, y of every asteroid in the level's order
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

  /** Keeps a gap if it is the smallest so far. */
  take(time: number, distance: number, kind: BodyKind, index: number): void {
    if (distance < this.least) this.best = { distance, kind, index, time };
  }
}
