import Flatbush from 'flatbush';
import type { Circles } from './circles.ts';

/** Lists of at least this many circles get an index; for shorter ones, plain loops are faster. */
const INDEX_FROM = 128;

/** Finds circles of one list near a place without examining all of them. Places are in px from the level's origin. */
export interface SpatialIndex {
  /**
   * Finds the circles that overlap a square.
   *
   * @param x - x of the square's centre, px
   * @param y - y of the square's centre, px
   * @param reach - half the side of the square, px
   * @returns indices of all such circles, in no particular order
   */
  around(x: number, y: number, reach: number): readonly number[];
  /**
   * Finds a circle whose centre is the nearest to a place.
   *
   * @param x - x of the place, px
   * @param y - y of the place, px
   * @returns index of one of the nearest
   */
  nearestCentre(x: number, y: number): number;
}

/** Makes an index of a list; null if the list is too short to be worth one. */
export function indexCircles(circles: Circles): SpatialIndex | null {
  if (circles.count < INDEX_FROM) return null;
  const boxes = new Flatbush(circles.count);
  const centres = new Flatbush(circles.count);
  for (let i = 0; i < circles.count; i++) {
    const x = circles.x[i];
    const y = circles.y[i];
    const r = circles.r[i];
    boxes.add(x - r, y - r, x + r, y + r);
    centres.add(x, y, x, y);
  }
  boxes.finish();
  centres.finish();
  return {
    around: (x, y, reach) => boxes.search(x - reach, y - reach, x + reach, y + reach),
    nearestCentre: (x, y) => centres.neighbors(x, y, 1)[0],
  };
}
