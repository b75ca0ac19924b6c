import Flatbush from 'flatbush';
import type { Circles } from './circles.ts';

/** From so many circles on a list is searched through an index; below, plain loops are faster. */
const INDEX_FROM = 128;

/** Finds the circles of one list near a place without looking at all of them. Places in px, as the level has them. */
export interface SpatialIndex {
  /** Indices of all circles that reach into the square of half-width `reach` around (x, y), in no order. */
  around(x: number, y: number, reach: number): readonly number[];
  /** A circle whose centre is among the nearest to (x, y). */
  nearestCentre(x: number, y: number): number;
}

/** An index of a list that is worth one, or null. */
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
