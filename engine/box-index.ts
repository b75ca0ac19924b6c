import Flatbush from 'flatbush';
import { type Circles, INDEX_FROM, type Indexing, type SpatialIndex } from './indexed-circles.ts';

function indexCircles(circles: Circles): SpatialIndex | null {
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

function indexBoxes(boxes: Float64Array): (k: number) => number[] {
  const index = new Flatbush(boxes.length / 4);
  for (let o = 0; o < boxes.length; o += 4) index.add(boxes[o], boxes[o + 1], boxes[o + 2], boxes[o + 3]);
  index.finish();
  return (k) => index.search(boxes[4 * k], boxes[4 * k + 1], boxes[4 * k + 2], boxes[4 * k + 3], (other) => other > k);
}

/** Indexes by trees of boxes, for lists of any length. */
export const INDEXING: Indexing = { circles: indexCircles, boxes: indexBoxes };
