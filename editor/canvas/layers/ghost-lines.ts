/** entries of `points` between two drawn points: every third tick is enough */
const STEP = 6;

/** largest difference between neighbouring steps, px: more than any force causes within three ticks */
const MOST_BEND = 6;

/** error of a second difference due to rounding to Float32, relative to the coordinate */
const ROUNDING = 5e-7;

/** A continuous stretch: x, y in px, alternating. */
export type Line = readonly number[];

/**
 * Splits a path of which only positions are known into continuous lines. It is cut where a step differs from both its
 * neighbours, as no step of a flight does: there an effect moved her at once.
 * @param points x, y in px, two entries per tick
 */
export function linesOf(points: Float32Array): Line[] {
  const lines: number[][] = [];
  let line: number[] = [];
  for (let i = 0; i + 1 < points.length; i += STEP) {
    if (i > 0 && isJump(points, i - STEP)) {
      lines.push(line);
      line = [];
    }
    line.push(points[i], points[i + 1]);
  }
  if (line.length > 0) lines.push(line);
  return lines;
}

function isJump(points: Float32Array, from: number): boolean {
  const most = MOST_BEND + ROUNDING * (Math.abs(points[from]) + Math.abs(points[from + 1]));
  const [before, behind] = [from - STEP, from + STEP];
  const neighbours = [before, behind].filter((i) => i >= 0 && i + STEP + 1 < points.length);
  if (neighbours.length === 0 || neighbours.some((other) => bend(points, from, other) <= most)) return false;
  // At either end there is only one neighbour: the longer of the two steps is the jump.
  return neighbours.length === 2 || lengthOf(points, from) > lengthOf(points, neighbours[0]) + most;
}

const lengthOf = (points: Float32Array, from: number): number =>
  Math.hypot(points[from + STEP] - points[from], points[from + STEP + 1] - points[from + 1]);

/** The difference of two steps, px. */
function bend(points: Float32Array, one: number, other: number): number {
  const dx = points[one + STEP] - points[one] - (points[other + STEP] - points[other]);
  const dy = points[one + STEP + 1] - points[one + 1] - (points[other + STEP + 1] - points[other + 1]);
  return Math.hypot(dx, dy);
}
