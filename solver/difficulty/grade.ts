/** What the grade is made from. */
export interface GradeInput {
  /** chance to succeed with timing noise of 40 ms, 0 to 1 */
  readonly p40: number;
  /** noise at which every second attempt succeeds, ms; at most the cap it was looked for under */
  readonly sigmaAtHalf: number;
  readonly presses: number;
  /** length of the run, s */
  readonly seconds: number;
  /** share of random play that wins, 0 to 1 */
  readonly randomShare: number;
}

/** An estimate of how hard a level is. */
export interface Grade {
  /** 1 to 10, one decimal */
  readonly value: number;
  readonly word: GradeWord;
}

export type GradeWord = 'gentle' | 'easy' | 'medium' | 'hard' | 'brutal';

/** Each word goes from its value up to the next one's. */
export const GRADE_WORDS: readonly (readonly [from: number, word: GradeWord])[] = [
  [1, 'gentle'],
  [2, 'easy'],
  [3.5, 'medium'],
  [5.5, 'hard'],
  [8, 'brutal'],
];

// parts of the grade, each from 0 to 1, in a sum of 1
const WEIGHTS = { timing: 0.25, risk: 0.2, search: 0.25, presses: 0.15, length: 0.15 } as const;

// sums that are grade 1 and grade 10: no level anybody would play comes nearer to 0 or to 1
const LEAST = 0.1;
const MOST = 0.85;

/**
 * The grade: 1 + 9 (sum - 0.1) / 0.75, held within 1 and 10; the sum is
 * 0.25 timing + 0.20 risk + 0.25 search + 0.15 presses + 0.15 length, each from 0 to 1:
 * - timing: 60 / (60 + s), s the noise in ms at which every second attempt succeeds
 * - risk: 1 - P(40 ms)
 * - search: 0.01 / (0.01 + r), r the share of random play that wins: a half where one game in a hundred is won
 * - presses: n / (n + 4)
 * - length: t / (t + 20), t in s
 *
 * An estimate, made from what is measurable in the best run known; it was not fitted to players.
 */
export function gradeOf(input: GradeInput): Grade {
  const timing = 60 / (60 + input.sigmaAtHalf);
  const risk = 1 - input.p40;
  const search = 0.01 / (0.01 + input.randomShare);
  const presses = input.presses / (input.presses + 4);
  const length = input.seconds / (input.seconds + 20);
  const sum =
    WEIGHTS.timing * timing + WEIGHTS.risk * risk + WEIGHTS.search * search + WEIGHTS.presses * presses + WEIGHTS.length * length;
  const grade = 1 + (9 * (sum - LEAST)) / (MOST - LEAST);
  const value = Math.round(Math.min(10, Math.max(1, grade)) * 10) / 10;
  let word = GRADE_WORDS[0][1];
  for (const [from, name] of GRADE_WORDS) if (value >= from) word = name;
  return { value, word };
}
