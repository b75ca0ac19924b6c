/** Where a march ends the root is mostly nearer than this before its last look, s. */
const NEAR = 1e-10;

/**
 * The moment a guard falls below 0 between a time at which it hasn't and one at which it has: bisection to the last bit that matters.
 * @param before s
 * @param behind s
 * @param isBehind whether the guard has fallen below 0 at a time, s
 * @returns s; a time at which it has
 */
export function bisect(before: number, behind: number, isBehind: (t: number) => boolean): number {
  let a = before;
  let b = behind;
  for (let width = NEAR; b - width > a; width *= 64) {
    if (isBehind(b - width)) b -= width;
    else a = b - width;
  }
  for (let n = 0; n < 60; n++) {
    const middle = a + (b - a) / 2;
    if (middle <= a || middle >= b) break;
    if (isBehind(middle)) b = middle;
    else a = middle;
  }
  return b;
}
