import type { IndexedCircles } from '../indexed-circles.ts';
import { MOVED, STRAYED, X, Y } from './layout.ts';
import { type Neighbourhood, Neighbourhoods } from './neighbourhoods.ts';
import { ROCK_LEEWAY } from './rocks.ts';
import type { World } from './world.ts';

/** This far from every object nothing matters to her, px. */
const AWAY = 1.5;

const NONE = new Int32Array(0);

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
  }

  /** The neighbourhood of her place. */
  here(): Neighbourhood {
    const { cell } = this;
    const { s } = this.world;
    const x = s[X];
    const y = s[Y];
    if (s[STRAYED] !== 0) this.cell = this.neighbourhoods.everything;
    else if (cell === this.neighbourhoods.everything || !(x >= cell.left && x < cell.right && y >= cell.top && y < cell.bottom))
      this.cell = this.neighbourhoods.at(x, y);
    return this.cell;
  }

  /**
   * Whether only the gun acts for a while. If so, `bounds` and `rivals` say where, and towards what.
   * @param room - how far she may move for other reasons, px
   */
  isAway(cell: Neighbourhood, room: number): boolean {
    const { bounds } = this;
    const { s, recoil } = this.world;
    this.rivals = cell.rivals;
    let half = room * 0.7 - 1e-3;
    if (cell.quiet) {
      bounds[0] = cell.freeLeft;
      bounds[1] = cell.freeRight;
      bounds[2] = cell.freeTop;
      bounds[3] = cell.freeBottom;
    } else {
      bounds[0] = cell.left;
      bounds[1] = cell.right;
      bounds[2] = cell.top;
      bounds[3] = cell.bottom;
      half = Math.min(half, this.gap(cell) - 1e-3);
    }
    if (half < AWAY) return false;
    if (recoil && cell.rivals.length > 1 && s[MOVED] > 0) {
      const lead = this.lead(cell.rivals);
      if (lead >= AWAY) {
        half = Math.min(half, lead);
        this.rivals = this.nearest;
      }
    }
    if (half === Number.POSITIVE_INFINITY) return true;
    // a square around her
    const x = s[X];
    const y = s[Y];
    if (x - half > bounds[0]) bounds[0] = x - half;
    if (x + half < bounds[1]) bounds[1] = x + half;
    if (y - half > bounds[2]) bounds[2] = y - half;
    if (y + half < bounds[3]) bounds[3] = y + half;
    return true;
  }

  /** How far she can move along each axis before another asteroid than `nearest` can be the nearest, px. */
  private lead(rivals: Int32Array): number {
    const { s, places, placesFrom, placesStep, rocks } = this.world;
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
    const leeway = s[STRAYED] === 0 ? ROCK_LEEWAY : rocks.leeway();
    return ((Math.sqrt(second) * (1 - 1e-9) - Math.sqrt(best) * (1 + 1e-9)) / 2 - leeway) * 0.7 - 1e-3;
  }

  /** How far she can move along each axis before anything in the neighbourhood can matter, px. */
  private gap(cell: Neighbourhood): number {
    const { s, range, recoil, rocks, places, placesFrom, placesStep, deadlyX, deadlyY, deadlyR, firstTarget } = this.world;
    const { collectableX, collectableY, collectableR, collected, box } = this.world;
    const { halfDiagonal } = box;
    const { rivals, deadly } = cell;
    if (rivals.length === 0) return 0;
    const leeway = s[STRAYED] === 0 ? ROCK_LEEWAY : rocks.leeway();
    const x = s[X];
    const y = s[Y];
    // the range depends on the distance
    let best = Number.POSITIVE_INFINITY;
    for (let k = 0; k < rivals.length; k++) {
      const o = placesFrom + placesStep * rivals[k];
      const dx = places[o] - x;
      const dy = places[o + 1] - y;
      best = Math.min(best, dx * dx + dy * dy);
    }
    let gap = (range - Math.sqrt(best) * (1 + 1e-9)) * 0.7 - leeway;
    for (let k = 0; k < deadly.length && gap >= AWAY; k++) {
      const code = deadly[k];
      const moves = recoil && code >= firstTarget;
      const o = placesFrom + placesStep * (code - firstTarget);
      const dx = Math.abs((moves ? places[o] : deadlyX[code]) - x);
      const dy = Math.abs((moves ? places[o + 1] : deadlyY[code]) - y);
      gap = Math.min(gap, (dx > dy ? dx : dy) - halfDiagonal - deadlyR[code] - leeway);
    }
    for (let k = 0; k < cell.collectables.length && gap >= AWAY; k++) {
      const i = cell.collectables[k];
      if (s[collected + i] !== 0) continue;
      const dx = Math.abs(collectableX[i] - x);
      const dy = Math.abs(collectableY[i] - y);
      gap = Math.min(gap, (dx > dy ? dx : dy) - halfDiagonal - collectableR[i]);
    }
    for (let k = 0; k < cell.discs.length && gap >= AWAY; k++) {
      const { x: discX, y: discY, r } = this.discs[k];
      for (const i of cell.discs[k]) {
        const dx = Math.abs(discX[i] - x);
        const dy = Math.abs(discY[i] - y);
        gap = Math.min(gap, (dx > dy ? dx : dy) - r[i]);
      }
    }
    return gap;
  }
}
