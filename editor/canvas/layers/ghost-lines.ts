/** Entries of `points` from one drawn place to the next: every third tick is enough. */
const STEP = 6;

/** By how much a step may differ from the steps beside it, px: more than any force makes of it in three ticks. */
const MOST_BEND = 6;

/** What rounding to a Float32 may do to a difference of differences, relative to the place. */
const ROUNDING = 5e-7;

/** A stretch that she flew: x, y in px in turn. */
export type Line = readonly number[];

/**
 * The lines of a way of which nothing is known but places: cut where a step is like neither the one before nor the one behind it,
 * as none that she flies is. There she was moved all at once.
 * @param points x, y in px, two entries a tick
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
  // at either end only one step lies beside it: of the two the longer one is the jump
  return neighbours.length === 2 || lengthOf(points, from) > lengthOf(points, neighbours[0]) + most;
}

const lengthOf = (points: Float32Array, from: number): number =>
  Math.hypot(points[from + STEP] - points[from], points[from + STEP + 1] - points[from + 1]);

/** By how much two steps differ, px. */
function bend(points: Float32Array, one: number, other: number): number {
  const dx = points[one + STEP] - points[one] - (points[other + STEP] - points[other]);
  const dy = points[one + STEP + 1] - points[one + 1] - (points[other + STEP + 1] - points[other + 1]);
  return Math.hypot(dx, dy);
}
