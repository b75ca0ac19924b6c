/** Two times nearer than this are one, s. */
const SAME = 1e-19;

/** What begins within this begins at once, s. */
const AT_ONCE = 1e-18;

/** Half a unit of the last digit of a time, as a share of it. */
const ROUNDING = 1.2e-16;

/** After so many evaluations the bracket is to be an eighth of what it was; else it is halved. */
const PATIENCE = 3;

/**
 * The moment a guard falls below 0 between a time at which it hasn't and one at which it has, to the last bit of the time:
 * regula falsi after Anderson and Björck (1973), halving where that is slow.
 * @param before s
 * @param behind s
 * @param guard its value at a time, s
 * @returns s; a time at which it is below 0
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
    // the value at the end that stays is cut, so that the next line cuts on its side
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

/** The same where two may touch at `before` already and move on into each other: then it is `before` itself. */
export function overlapBetween(before: number, behind: number, gap: (t: number) => number): number {
  const t = crossing(before, behind, gap);
  return t - before < AT_ONCE ? before : t;
}
