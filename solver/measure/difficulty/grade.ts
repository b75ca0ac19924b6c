/** What the grade is computed from. */
export interface GradeInput {
  /** Success under timing noise of 40 ms, 0 to 1. */
  readonly p40: number;
  /** The timing noise at which half of all attempts succeed, ms; at most {@link SIGMA_CAP}. */
  readonly sigmaAtHalf: number;
  /** The number of presses. */
  readonly presses: number;
  /** Length of the run, s. */
  readonly seconds: number;
  /** The share of random play that meets the goal, 0 to 1. */
  readonly randomShare: number;
}

/** An estimate of how hard a level is. */
export interface Grade {
  /** The grade, from 1 to 10 with one decimal. */
  readonly value: number;
  /** The grade in one word. */
  readonly word: GradeWord;
}

/** A grade in one word, from the easiest to the hardest. */
export type GradeWord = 'gentle' | 'easy' | 'medium' | 'hard' | 'brutal';

/** The least grade of each word, ascending. A word applies up to the next one's least grade. */
export const GRADE_WORDS: readonly (readonly [from: number, word: GradeWord])[] = [
  [1, 'gentle'],
  [2, 'easy'],
  [3.5, 'medium'],
  [5.5, 'hard'],
  [8, 'brutal'],
];

// Weights of the parts; their sum is 1.
const WEIGHTS = { timing: 0.25, risk: 0.2, search: 0.25, presses: 0.15, length: 0.15 } as const;

// The weighted sums of grade 1 and grade 10. No level that anybody would play comes nearer to 0 or 1.
const LEAST = 0.1;
const MOST = 0.85;

/** How little a run forgives, from 0 to 0.45: the parts of the grade for timing and risk. */
export const strictnessOf = ({ p40, sigmaAtHalf }: Pick<GradeInput, 'p40' | 'sigmaAtHalf'>): number =>
  (WEIGHTS.timing * 60) / (60 + sigmaAtHalf) + WEIGHTS.risk * (1 - p40);

/**
 * Computes how hard a level is without the limits and the rounding of the grade: 1 + 9 (sum - 0.1) / 0.75, see {@link gradeOf}.
 */
export function hardnessOf(input: GradeInput): number {
  const search = 0.01 / (0.01 + input.randomShare);
  const presses = input.presses / (input.presses + 4);
  const length = input.seconds / (input.seconds + 20);
  const sum = strictnessOf(input) + WEIGHTS.search * search + WEIGHTS.presses * presses + WEIGHTS.length * length;
  return 1 + (9 * (sum - LEAST)) / (MOST - LEAST);
}

/**
 * Computes the grade: 1 + 9 (sum - 0.1) / 0.75, clamped to 1 to 10. The sum is 0.25 timing + 0.20 risk + 0.25 search + 0.15
 * presses + 0.15 length, and each part goes from 0 to 1:
 * - timing: 60 / (60 + s), where s is the timing noise in ms at which half of all attempts succeed
 * - risk: 1 - success at 40 ms
 * - search: 0.01 / (0.01 + r), where r is the share of random play that wins; 1/2 where one game in a hundred wins
 * - presses: n / (n + 4)
 * - length: t / (t + 20), t in s
 *
 * The grade of a level is the lowest that any of its known runs gives. It is an estimate, and was not fitted to
 * players.
 */
export function gradeOf(input: GradeInput): Grade {
  const value = Math.round(Math.min(10, Math.max(1, hardnessOf(input))) * 10) / 10;
  let word = GRADE_WORDS[0][1];
  for (const [from, name] of GRADE_WORDS) if (value >= from) word = name;
  return { value, word };
}
