interface Point {
  readonly x: number;
  readonly y: number;
}

interface Size {
  readonly width: number;
  readonly height: number;
}

/** px of screen from the point to its label */
const BESIDE = 16;
/** px of screen from a label to the edges of the view */
const MARGIN = 8;
/** the same to its upper edge, along which the tools stand */
const BELOW_TOOLS = 56;

/** The sides of a point on which its label can be, the best first: how far each shifts the label, in parts of its size. */
const SIDES = [
  { across: 0.5, along: 0 },
  { across: -0.5, along: 0 },
  { across: 0, along: 0.5 },
  { across: 0, along: -0.5 },
] as const;

/**
 * Finds a place for a label beside a point, within the view, on the side where it covers least. All lengths are px of screen.
 * @param label size of the label
 * @param covered points that the label should not cover
 * @returns the label's centre
 */
export function labelPlace(point: Point, label: Size, view: Size, covered: readonly Point[]): Point {
  const within = (value: number, half: number, size: number, first = MARGIN) =>
    Math.max(half + first, Math.min(size - half - MARGIN, value));
  const [halfWidth, halfHeight] = [label.width / 2, label.height / 2];
  let best = point;
  let least = Number.POSITIVE_INFINITY;
  for (const { across, along } of SIDES) {
    const x = within(point.x + across * (label.width + 2 * BESIDE), halfWidth, view.width);
    const y = within(point.y + along * (label.height + 2 * BESIDE), halfHeight, view.height, BELOW_TOOLS);
    const covers = (other: Point) => Math.abs(other.x - x) < halfWidth && Math.abs(other.y - y) < halfHeight;
    // the point itself is covered only where the view has too little room on this side
    const count = covered.filter(covers).length + (covers(point) ? covered.length + 1 : 0);
    if (count >= least) continue;
    least = count;
    best = { x, y };
  }
  return best;
}
