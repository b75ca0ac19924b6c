/** A level that is much harder than all before it. */
export interface Jump {
  /** Its place among the levels, from 0. */
  readonly index: number;
  /** The place of the hardest level before it. */
  readonly from: number;
  /** By how much its grade is higher. */
  readonly by: number;
}

/** A grade (1 to 10) that is higher than all before by this much and more is a jump: the words of grades are about as far apart. */
export const JUMP = 2;

/**
 * The jumps of a curve of difficulty: levels whose grade is at least {@link JUMP} above the highest grade before them. A first
 * level is none, since nothing comes before it.
 *
 * @param grades - the grades in the order in which the levels are played; null where none is known
 */
export function jumpsOf(grades: readonly (number | null)[]): Jump[] {
  const jumps: Jump[] = [];
  let hardest: { readonly index: number; readonly grade: number } | null = null;
  for (const [index, grade] of grades.entries()) {
    if (grade === null) continue;
    // tenths, so that rounding of the difference does not decide
    const by: number = hardest === null ? 0 : Math.round(10 * (grade - hardest.grade)) / 10;
    if (hardest !== null && by >= JUMP) jumps.push({ index, from: hardest.index, by });
    if (hardest === null || grade > hardest.grade) hardest = { index, grade };
  }
  return jumps;
}
