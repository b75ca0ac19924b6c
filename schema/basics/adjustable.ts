/** How far a configuration, and `allow` in a level, can change the problems of a code. */
export interface Adjustment {
  /**
   * `free`: every problem of this code; `warnings`: only where it is a warning, because as an error it decides the verdict;
   * `fixed`: none, it is always an error.
   */
  readonly severity: 'free' | 'warnings' | 'fixed';
  /** Whether a level can allow it. */
  readonly allow: boolean;
}

const FREE = { severity: 'free', allow: true } as const;
const WARNINGS = { severity: 'warnings', allow: true } as const;
/** About the configuration or the project, so no level can allow it. */
const NOT_IN_A_LEVEL = { severity: 'free', allow: false } as const;
const FIXED = { severity: 'fixed', allow: false } as const;

/**
 * What can be changed about the problems that a check of a readable level finds, in the order in which they are listed. Codes of
 * `PROBLEM_CODES` are not listed: they are always errors.
 */
export const ADJUSTMENTS = {
  'run-does-not-complete': WARNINGS,
  'no-run': FIXED,
  'found-run': FREE,
  'no-run-found': FIXED,
  'proved-impossible': FIXED,
  'mineral-never-collectable': FREE,
  softlock: FREE,
  'low-slack': FREE,
  'slack-below-required': FREE,
  'verdict-hangs-on-accuracy': FREE,
  'work-limit': WARNINGS,
  'result-changed': NOT_IN_A_LEVEL,
  'not-in-lock': NOT_IN_A_LEVEL,
  'unused-allow': NOT_IN_A_LEVEL,
  'pack-missing-level': NOT_IN_A_LEVEL,
  'pack-repeated-level': NOT_IN_A_LEVEL,
  'pack-unlisted-level': NOT_IN_A_LEVEL,
  'pack-introduction': NOT_IN_A_LEVEL,
  'pack-empty-chapter': NOT_IN_A_LEVEL,
  'unreadable-file': FIXED,
  crashed: FIXED,
  'nothing-in-range-at-start': FREE,
  'starts-in-hazard': FREE,
  'touches-black-hole-at-start': FREE,
  'black-hole-out-of-reach': FREE,
  'black-hole-covered': FREE,
  'mineral-out-of-reach': FREE,
  'mineral-covered': FREE,
  'aliens-explode-at-start': FREE,
  'repulsor-never-acts': FREE,
  'same-place': FREE,
  overlapping: FREE,
  'holds-overlap': FREE,
  'holds-unsorted': FREE,
  'unused-asteroid': FREE,
} as const satisfies Readonly<Record<string, Adjustment>>;

/** A code whose severity a configuration can set. */
export type AdjustableCode = {
  [C in keyof typeof ADJUSTMENTS]: (typeof ADJUSTMENTS)[C]['severity'] extends 'fixed' ? never : C;
}[keyof typeof ADJUSTMENTS];

/** A code that a level can allow. */
export type AllowableCode = {
  [C in keyof typeof ADJUSTMENTS]: (typeof ADJUSTMENTS)[C]['allow'] extends true ? C : never;
}[keyof typeof ADJUSTMENTS];

const codes = Object.keys(ADJUSTMENTS) as (keyof typeof ADJUSTMENTS)[];

/** The codes whose severity a configuration can set. */
export const ADJUSTABLE_CODES = codes.filter((code) => ADJUSTMENTS[code].severity !== 'fixed') as readonly AdjustableCode[];

/** The codes that a level can allow. */
export const ALLOWABLE_CODES = codes.filter((code) => ADJUSTMENTS[code].allow) as readonly AllowableCode[];

/** The codes of all problems that reading or importing a file can give. */
const PROBLEM_CODES = [
  'file-too-large',
  'empty-file',
  'not-a-level',
  'pointer-file',
  'not-utf8',
  'byte-order-mark',
  'invalid-json',
  'truncated-json',
  'too-deep',
  'duplicate-key',
  'not-a-number',
  'number-too-large',
  'comment',
  'trailing-comma',
  'wrong-quotes',
  'missing-version',
  'newer-version',
  'unsupported-version',
  'unknown-key',
  'missing-key',
  'wrong-type',
  'out-of-limits',
  'not-whole',
  'too-many',
  'empty-text',
  'text-too-long',
  'bad-id',
  'duplicate-id',
  'duplicate-run-name',
  'reversed-hold',
  'merge-markers',
  'merge-conflict',
  'one-per-level',
  'nothing-to-import',
  'not-in-original',
  'unknown-class',
  'wrong-shape',
  'unpaired-mouth',
  'unsupported-map',
  'unknown-code',
  'fixed-severity',
  'unknown-value',
  'empty-list',
  'more-problems',
] as const;

/** The code of a problem that reading or importing a file can give. */
export type ProblemCode = (typeof PROBLEM_CODES)[number];

/**
 * What can be changed about the problems of a code.
 *
 * @param code - any text
 * @returns the adjustment; of the code of a file that is no level, that it is fixed; null if there is no such code
 */
export function adjustmentOf(code: string): Adjustment | null {
  if (Object.hasOwn(ADJUSTMENTS, code)) return ADJUSTMENTS[code as keyof typeof ADJUSTMENTS];
  return PROBLEM_CODES.some((known) => known === code) ? { severity: 'fixed', allow: false } : null;
}

/** Every code that there is. */
export const allCodes = (): string[] => [...Object.keys(ADJUSTMENTS), ...PROBLEM_CODES];
