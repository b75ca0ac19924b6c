import type { Disc } from '../../schema/basics/index.ts';
import type { HazardList } from '../clearance.ts';
import type { Circles, IndexedCircles, SpatialIndex } from '../indexed-circles.ts';
import type { Scene } from '../scene.ts';

/** A square's half diagonal divided by half its side, rounded up. */
const DIAGONAL = 1.4143;

export const NONE = new Int32Array(0);

/** What may see her, where the level places it, and how far it sees, px. */
export interface Watchers {
  readonly circles: Circles;
  readonly sight: number;
}

/** Circles of which those from `first` on end the run by touch. */
export interface Deadly extends HazardList {
  /** The code of the first circle. */
  readonly from: number;
}

/**
 * A square whose surroundings are examined: what can matter to her anywhere in it. What it finds collects in a list, ascending,
 * until that is taken. One square serves for many: a run makes dozens of them.
 */
export class Square {
  private x = 0;
  private y = 0;
  /** Upper bound of the distance from the centre to any place in it, px. */
  private toCorner = 0;
  /** Distance from the centre to the nearest target, px; Infinity if there is none. */
  private closest = Number.POSITIVE_INFINITY;
  private readonly found: number[] = [];

  // levels are objects of many shapes: see `world.ts`
  private readonly hole: Disc;
  private readonly halfDiagonal: number;
  private readonly targets: IndexedCircles;

  /** @param drift - how far recoil may have moved an asteroid, px */
  constructor(
    { level, box, targets }: Scene,
    private readonly chasers: Watchers,
    private readonly deadly: readonly Deadly[],
    private readonly drift: number,
  ) {
    const { x, y, radius } = level.blackHole;
    this.hole = { x, y, radius };
    this.halfDiagonal = box.halfDiagonal;
    this.targets = targets;
  }

  /** Moves its centre to (x, y), px, and makes its sides 2 `half` px long. */
  place(x: number, y: number, half: number): void {
    this.x = x;
    this.y = y;
    this.toCorner = half * DIAGONAL;
    this.closest = this.nearestTarget();
  }

  /**
   * Empties the list and returns what it had.
   * @param like - is returned where it has the same: neighbours mostly have, and an array takes longer to make than to fill
   */
  taken(like: Int32Array): Int32Array {
    const { found } = this;
    if (found.length === 0) return NONE;
    let k = 0;
    if (like.length === found.length) while (k < found.length && like[k] === found[k]) k++;
    if (k === found.length) {
      found.length = 0;
      return like;
    }
    // a loop: `Int32Array.from` takes several times as long
    const list = new Int32Array(found.length);
    for (let k = 0; k < list.length; k++) list[k] = found[k];
    found.length = 0;
    return list;
  }

  /** Adds what ends the run by touch, by its code; 0 is the black hole. */
  addDeadly(): void {
    const { hole, halfDiagonal } = this;
    if (this.within(this.distance(hole.x, hole.y), halfDiagonal + hole.radius)) this.found.push(0);
    for (const { circles, first, from, movedBy } of this.deadly) {
      this.add(circles, circles.spatial, first, from, halfDiagonal, movedBy === 'recoil' ? this.drift : 0);
    }
  }

  /** Adds circles that she may touch. */
  addTouching(circles: IndexedCircles): void {
    this.add(circles, circles.spatial, 0, 0, this.halfDiagonal, 0);
  }

  /** Adds the discs that her centre may enter. */
  addDiscs(discs: IndexedCircles): void {
    this.add(discs, discs.spatial, 0, 0, 0, 0);
  }

  /** Adds the targets that may be the nearest. */
  addRivals(): void {
    const { closest, found, toCorner, drift } = this;
    const { targets } = this;
    const reach = closest + 2 * (toCorner + drift);
    const near = this.around(targets.spatial, (reach + 1) * (1 + 1e-9));
    const count = near?.length ?? targets.count;
    for (let k = 0; k < count; k++) {
      const i = near === null ? k : near[k];
      if (this.within(this.distance(targets.x[i], targets.y[i]), reach)) found.push(i);
    }
  }

  /** Whether chasers at their places in the level neither see nor touch her. */
  get isUnseen(): boolean {
    const { halfDiagonal } = this;
    const { circles, sight } = this.chasers;
    for (let i = 0; i < circles.count; i++) {
      const reach = Math.max(sight, halfDiagonal + circles.r[i]);
      if (this.within(this.distance(circles.x[i], circles.y[i]), reach)) return false;
    }
    return true;
  }

  /**
   * Adds circles that come within `margin` px of her somewhere in the square.
   * @param first - the index of the first that counts
   * @param offset - what is added to an index
   * @param moves - how far they may have moved, px
   */
  private add(
    circles: Circles,
    spatial: SpatialIndex | null,
    first: number,
    offset: number,
    margin: number,
    moves: number,
  ): void {
    const near = this.around(spatial, this.toCorner + margin + moves + 1);
    const count = near?.length ?? circles.count;
    for (let k = near === null ? first : 0; k < count; k++) {
      const i = near === null ? k : near[k];
      if (i < first) continue;
      if (this.within(this.distance(circles.x[i], circles.y[i]), margin + circles.r[i] + moves)) this.found.push(offset + i);
    }
  }

  /** Indices, ascending, of at least all circles that come nearer than `reach` px to the centre; null for all of them. */
  private around(spatial: SpatialIndex | null, reach: number): readonly number[] | null {
    return spatial === null ? null : [...spatial.around(this.x, this.y, reach)].sort((a, b) => a - b);
  }

  /** Distance of a place from the centre, px. */
  private distance(x: number, y: number): number {
    return Math.sqrt((x - this.x) * (x - this.x) + (y - this.y) * (y - this.y));
  }

  /**
   * Whether what is `d` px from the centre may be nearer than `reach` px to a place in the square. The margin is far above any
   * rounding.
   */
  private within(d: number, reach: number): boolean {
    return d <= (reach + this.toCorner + 1e-3) * (1 + 1e-9) + d * 1e-9;
  }

  private nearestTarget(): number {
    const { targets } = this;
    if (targets.spatial !== null) {
      const i = targets.spatial.nearestCentre(this.x, this.y);
      return this.distance(targets.x[i], targets.y[i]);
    }
    let closest = Number.POSITIVE_INFINITY;
    for (let i = 0; i < targets.count; i++) closest = Math.min(closest, this.distance(targets.x[i], targets.y[i]));
    return closest;
  }
}
