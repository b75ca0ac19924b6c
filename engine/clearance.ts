import { boxCircleGap } from './contact.ts';
import type { IndexedCircles } from './indexed-circles.ts';
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

  /** The smallest gap is known to be less than this, px. */
  most = Number.POSITIVE_INFINITY;

  /** The number of hazards. */
  readonly count: number;

  /** @param lists - all hazards of the scene; of equally near ones the first counts */
  constructor(
    private readonly scene: Scene,
    readonly lists: readonly HazardList[],
  ) {
    this.count = hazardCount(lists);
  }

  /** The smallest gap so far, px; before the first, what it is known to be less than. */
  get least(): number {
    return this.best === null ? this.most : this.best.distance;
  }

  /**
   * Takes one state into account: time in s, her place in px, the box's direction as a unit vector.
   * @param chasers - x, y, alive of every object that chases her
   * @param asteroids - x, y of every asteroid in the level's order
   */
  see(time: number, x: number, y: number, cos: number, sin: number, chasers: Float64Array, asteroids: Float64Array): void {
    const { box } = this.scene;
    for (const { kind, circles, first, movedBy } of this.lists) {
      for (let i = first; i < circles.count; i++) {
        const k = circles.index[i];
        if (movedBy === 'chase' && chasers[3 * k + 2] === 0) continue;
        const atX = movedBy === 'chase' ? chasers[3 * k] : movedBy === 'recoil' ? asteroids[2 * k] : circles.x[i];
        const atY = movedBy === 'chase' ? chasers[3 * k + 1] : movedBy === 'recoil' ? asteroids[2 * k + 1] : circles.y[i];
        this.take(time, boxCircleGap(box, atX - x, atY - y, cos, sin, circles.r[i]), kind, k);
      }
    }
  }

  /** Keeps a gap if it is the smallest so far. */
  take(time: number, distance: number, kind: BodyKind, index: number): void {
    if (distance < this.least) this.best = { distance, kind, index, time };
  }
}

/** Circles of one kind that end a run on touch. */
export interface HazardList {
  readonly kind: BodyKind;
  readonly circles: IndexedCircles;
  /** The first of the circles that is deadly. */
  readonly first: number;
  /** What moves them during a run: nothing, recoil as it moves asteroids, or a chase. */
  readonly movedBy: 'nothing' | 'recoil' | 'chase';
}

/** The number of hazards in some lists. */
export const hazardCount = (lists: readonly HazardList[]): number =>
  lists.reduce((sum, { circles, first }) => sum + circles.count - first, 0);
