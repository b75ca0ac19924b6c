/** A point of a plane. */
export interface Vertex {
  readonly x: number;
  readonly y: number;
}

const turn = (o: Vertex, a: Vertex, b: Vertex): number => (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);

/** The corners of the convex hull of some points, in order around it. */
export function convexHull(points: readonly Vertex[]): Vertex[] {
  const sorted = [...points].sort((a, b) => a.x - b.x || a.y - b.y);
  const chain = (ordered: readonly Vertex[]): Vertex[] => {
    const kept: Vertex[] = [];
    for (const point of ordered) {
      while (kept.length > 1 && turn(kept[kept.length - 2], kept[kept.length - 1], point) <= 0) kept.pop();
      kept.push(point);
    }
    return kept;
  };
  const lower = chain(sorted);
  const upper = chain(sorted.reverse());
  return lower.length < 2 ? lower : [...lower.slice(0, -1), ...upper.slice(0, -1)];
}

/** The part of a convex polygon in which the linear function `side` is not negative. */
export function cutOff(polygon: readonly Vertex[], side: (p: Vertex) => number): Vertex[] {
  return polygon.flatMap((a, i) => {
    const b = polygon[(i + 1) % polygon.length];
    const sa = side(a);
    const sb = side(b);
    const kept = sa >= 0 ? [a] : [];
    if (sa >= 0 === sb >= 0) return kept;
    const t = sa / (sa - sb);
    return [...kept, { x: a.x + t * (b.x - a.x), y: a.y + t * (b.y - a.y) }];
  });
}

/** The part of a convex polygon between two values of x. */
export const between = (polygon: readonly Vertex[], from: number, to: number): Vertex[] =>
  cutOff(
    cutOff(polygon, (p) => p.x - from),
    (p) => to - p.x,
  );
