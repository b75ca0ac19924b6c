/** Times nearer than this count as equal, s. */
const SAME = 1e-19;

/** What begins within this time begins at once, s. */
const AT_ONCE = 1e-18;

/** Relative rounding error of a time: half a unit in the last place. */
const ROUNDING = 1.2e-16;

/** After this many evaluations the bracket must have shrunk to an eighth; otherwise it is halved. */
const PATIENCE = 3;

/**
 * The moment at which a guard falls below 0, to the last bit of the time: regula falsi after Anderson and Björck (1973), with
 * halving where that is slow.
 * @param before - a time at which the guard is not below 0, s
 * @param behind - a later time at which it is, s
 * @param guard - its value at a time, s
 * @returns a time at which the guard is below 0, s
 */
export function crossing(before: number, behind: number, guard: (t: number) => number): number {
  let a = before;
  let b = behind;
  let atA = Math.max(0, guard(a));
  let atB = guard(b);
  if (!(atB < 0)) return b;
  let side = 0;
  let wide = Number.POSITIVE_INFINITY;
  for (let n = 0; ; n++) {
    const width = b - a;
    const least = Math.max(SAME, ROUNDING * b);
    if (width <= least) return b;
    let t = a + width * (atA / (atA - atB));
    if (n % PATIENCE === 0) {
      if (width > wide / 8) t = a + width / 2;
      wide = width;
    }
    t = Math.min(Math.max(t, a + least), b - least);
    if (!(t > a && t < b)) t = a + width / 2;
    if (!(t > a && t < b)) return b;
    const g = guard(t);
    // the value at the end that stays is reduced, so that the next secant ends on its side of the root
    if (g < 0) {
      if (side < 0) atA *= g > atB ? 1 - g / atB : 0.5;
      b = t;
      atB = g;
      side = -1;
    } else {
      if (side > 0) atB *= g < atA ? 1 - g / atA : 0.5;
      a = t;
      atA = g;
      side = 1;
    }
  }
}

/** The same where two bodies may touch at `before` already and move into each other: then the result is `before` itself. */
export function overlapBetween(before: number, behind: number, gap: (t: number) => number): number {
  const t = crossing(before, behind, gap);
  return t - before < AT_ONCE ? before : t;
}
