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
 * {@link CODES} are not listed: they are always errors.
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
