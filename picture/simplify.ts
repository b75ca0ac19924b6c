/** A point, px of the level or units of the picture. */
export type PathPoint = readonly [x: number, y: number];

/**
 * Removes points of a line that are less than `tolerance` away from the simplified line (Ramer 1972, Douglas and Peucker 1973).
 * The first and the last point stay. It is iterative, because recursion on a long run would overflow the stack.
 */
export function simplify(points: readonly PathPoint[], tolerance: number): PathPoint[] {
  if (points.length < 3) return [...points];
  const keep = new Uint8Array(points.length);
  keep[0] = 1;
  keep[points.length - 1] = 1;
  const spans: [number, number][] = [[0, points.length - 1]];
  for (let span = spans.pop(); span !== undefined; span = spans.pop()) {
    const [from, to] = span;
    let worst = tolerance * tolerance;
    let split = -1;
    for (let i = from + 1; i < to; i++) {
      const d = squaredDistance(points[i], points[from], points[to]);
      if (d <= worst) continue;
      worst = d;
      split = i;
    }
    if (split < 0) continue;
    keep[split] = 1;
    spans.push([from, split], [split, to]);
  }
  return points.filter((_, i) => keep[i] === 1);
}

/** Squared distance of a point from the segment a b. */
function squaredDistance([x, y]: PathPoint, [ax, ay]: PathPoint, [bx, by]: PathPoint): number {
  const dx = bx - ax;
  const dy = by - ay;
  const length = dx * dx + dy * dy;
  const t = length === 0 ? 0 : Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / length));
  const ex = x - ax - t * dx;
  const ey = y - ay - t * dy;
  return ex * ex + ey * ey;
}
