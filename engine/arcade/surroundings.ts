import type { IndexedCircles } from '../indexed-circles.ts';
import { MOVED, STRAYED, VX, VY, X, Y } from './layout.ts';
import { type Neighbourhood, Neighbourhoods } from './neighbourhoods.ts';
import { ROCK_LEEWAY } from './rocks.ts';
import type { World } from './world.ts';

/** This far from every object nothing matters to her, px. */
const AWAY = 1.5;

/** In a small level, a target is followed alone from this lead on, px: for less, it takes longer to find out than it saves. */
const CLEAR_LEAD = 16;

const NONE = new Int32Array(0);

/** Whether a circle, `dx` and `dy` px from her, is out of her way while she moves less than `half` px along each axis. */
const isBeside = (dx: number, dy: number, r: number, half: number): boolean =>
  Math.abs(dx) - r - 1e-3 >= half || Math.abs(dy) - r - 1e-3 >= half;

/** What is around her, and how far nothing but the gun acts. */
export class Surroundings {
  /** Left, right, top and bottom of the area in which only the gun acts, px. */
  readonly bounds: Float64Array = new Float64Array(4);
  /** Targets that may be the nearest within the area. */
  rivals: Int32Array = NONE;
  private readonly nearest = new Int32Array(1);
  private readonly discs: readonly IndexedCircles[];
  private readonly neighbourhoods: Neighbourhoods;
  private cell: Neighbourhood;
  /** Whether the whole level is one neighbourhood. */
  readonly isOne: boolean;

  constructor(private readonly world: World) {
    this.discs = world.frameRules.map((rule) => rule.discs(world.scene));
    this.neighbourhoods = new Neighbourhoods(
      world.scene,
      world.chasers,
      world.deadly,
      world.collectables,
      this.discs,
      world.frameRules.map(({ isWork }) => isWork === true),
    );
    this.cell = this.neighbourhoods.everything;
    this.isOne = this.neighbourhoods.isOne;
  }

  /** The neighbourhood of her place. */
  here(): Neighbourhood {
    const { cell } = this;
    const { s } = this.world;
    const x = s[X];
    const y = s[Y];
    if (this.isOne || s[STRAYED] !== 0) this.cell = this.neighbourhoods.everything;
    else if (cell === this.neighbourhoods.everything || !(x >= cell.left && x < cell.right && y >= cell.top && y < cell.bottom))
      this.cell = this.neighbourhoods.at(x, y);
    return this.cell;
  }

  /**
   * Whether only the gun acts for a while. If so, `bounds` and `rivals` say where, and towards what.
   * @param room - how far she may move for other reasons, px
   */
  isAway(cell: Neighbourhood, room: number, held: boolean): boolean {
    const { bounds, isOne } = this;
    const { s, recoil } = this.world;
    this.rivals = cell.rivals;
    let half = room * 0.7 - 1e-3;
    this.within(cell.left, cell.right, cell.top, cell.bottom, half);
    if (half >= AWAY) half = this.keepClear(cell, half);
    if (half < AWAY) return false;
    if (cell.rivals.length > 1 && ((recoil && s[MOVED] > 0) || (held && isOne))) {
      const lead = this.lead(cell.rivals);
      if (lead >= (isOne ? CLEAR_LEAD : AWAY)) {
        half = Math.min(half, lead);
        this.rivals = this.nearest;
      }
    }
    this.within(bounds[0], bounds[1], bounds[2], bounds[3], half);
    return true;
  }

  /**
   * Sets `bounds` to those of a neighbourhood.
   * @param room - how far she may move, px
   */
  stayIn({ left, right, top, bottom }: Neighbourhood, room: number): void {
    this.within(left, right, top, bottom, room * 0.7);
  }

  /** Sets the bounds to what is also in a square around her. @param half - half its side, px */
  private within(left: number, right: number, top: number, bottom: number, half: number): void {
    const { bounds } = this;
    const { s } = this.world;
    bounds[0] = Math.max(left, s[X] - half);
    bounds[1] = Math.min(right, s[X] + half);
    bounds[2] = Math.max(top, s[Y] - half);
    bounds[3] = Math.min(bottom, s[Y] + half);
  }

  /** How far she can move along each axis before another asteroid than `nearest` can be the nearest, px. */
  private lead(rivals: Int32Array): number {
    const { s, recoil, places, placesFrom, placesStep, rocks } = this.world;
    let best = Number.POSITIVE_INFINITY;
    let second = Number.POSITIVE_INFINITY;
    for (let k = 0; k < rivals.length; k++) {
      const o = placesFrom + placesStep * rivals[k];
      const dx = places[o] - s[X];
      const dy = places[o + 1] - s[Y];
      const d2 = dx * dx + dy * dy;
      if (d2 < best) {
        second = best;
        best = d2;
        this.nearest[0] = rivals[k];
      } else if (d2 < second) {
        second = d2;
      }
    }
    const leeway = !recoil ? 0 : s[STRAYED] === 0 ? ROCK_LEEWAY : rocks.leeway();
    return ((Math.sqrt(second) * (1 - 1e-9) - Math.sqrt(best) * (1 + 1e-9)) / 2 - leeway) * 0.7 - 1e-3;
  }

  /**
   * Makes the bounds end before whatever in the neighbourhood can matter.
   * @param room - how far she may move along each axis for other reasons, px
   * @returns how far she can move along each axis within the bounds, px; less than {@link AWAY} if something is too near
   */
  private keepClear(cell: Neighbourhood, room: number): number {
    const { s, range, recoil, rocks, places, placesFrom, placesStep, deadlyX, deadlyY, deadlyR, firstTarget } = this.world;
    const { collectableX, collectableY, collectableR, collected, box } = this.world;
    const { halfDiagonal } = box;
    const { rivals, deadly, collectables } = cell;
    if (rivals.length === 0) return 0;
    const leeway = !recoil ? 0 : s[STRAYED] === 0 ? ROCK_LEEWAY : rocks.leeway();
    const x = s[X];
    const y = s[Y];
    // the range depends on the distance
    let best = Number.POSITIVE_INFINITY;
    for (let k = 0; k < rivals.length; k++) {
      const o = placesFrom + placesStep * rivals[k];
      const dx = places[o] - x;
      const dy = places[o + 1] - y;
      const d2 = dx * dx + dy * dy;
      if (d2 < best) best = d2;
    }
    const inRange = (range - Math.sqrt(best) * (1 + 1e-9)) * 0.7 - leeway - 1e-3;
    let half = inRange < room ? inRange : room;
    for (let k = 0; k < deadly.length && half >= AWAY; k++) {
      const code = deadly[k];
      const moves = recoil && code >= firstTarget;
      const o = placesFrom + placesStep * (code - firstTarget);
      const atX = moves ? places[o] : deadlyX[code];
      const atY = moves ? places[o + 1] : deadlyY[code];
      const r = halfDiagonal + deadlyR[code] + leeway;
      if (!isBeside(atX - x, atY - y, r, half)) half = this.leaveOut(atX - x, atY - y, r, half);
    }
    for (let k = 0; k < collectables.length && half >= AWAY; k++) {
      const i = collectables[k];
      if (s[collected + i] !== 0) continue;
      const dx = collectableX[i] - x;
      const dy = collectableY[i] - y;
      const r = halfDiagonal + collectableR[i];
      if (!isBeside(dx, dy, r, half)) half = this.leaveOut(dx, dy, r, half);
    }
    for (let k = 0; k < cell.discs.length && half >= AWAY; k++) {
      const { x: discX, y: discY, r } = this.discs[k];
      const near = cell.discs[k];
      for (let n = 0; n < near.length; n++) half = this.leaveOut(discX[near[n]] - x, discY[near[n]] - y, r[near[n]], half);
    }
    return half;
  }

  /**
   * Makes the bounds end before a circle, on the side that she approaches more slowly.
   * @param dx - x of its centre relative to her, px
   * @param dy - y of its centre relative to her, px
   * @param half - how far she may move along each axis, px
   * @returns how far she may still move along each axis, px
   */
  private leaveOut(dx: number, dy: number, r: number, half: number): number {
    if (isBeside(dx, dy, r, half)) return half;
    const { bounds } = this;
    const { s } = this.world;
    const besideX = Math.abs(dx) - r - 1e-3;
    const besideY = Math.abs(dy) - r - 1e-3;
    if (besideX < AWAY && besideY < AWAY) return Math.min(half, (Math.sqrt(dx * dx + dy * dy) - r) * 0.7 - 1e-3);
    const towardsX = Math.max(1, dx > 0 ? s[VX] : -s[VX]);
    const towardsY = Math.max(1, dy > 0 ? s[VY] : -s[VY]);
    if (besideY < AWAY || (besideX >= AWAY && besideX * towardsY > besideY * towardsX)) {
      if (dx > 0) bounds[1] = Math.min(bounds[1], s[X] + besideX);
      else bounds[0] = Math.max(bounds[0], s[X] - besideX);
    } else if (dy > 0) {
      bounds[3] = Math.min(bounds[3], s[Y] + besideY);
    } else {
      bounds[2] = Math.max(bounds[2], s[Y] - besideY);
    }
    return half;
  }
}
