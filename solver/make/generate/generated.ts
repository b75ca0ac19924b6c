import type { Hold, LevelFile } from '../../../schema/index.ts';
import type { Grade } from '../../measure/difficulty/index.ts';
import type { Robustness } from '../../measure/robustness/index.ts';
import type { SymmetryKind, ThemeName } from './generator-spec.ts';

/** A generated level with its measurements. */
export interface Generated {
  /** The level file with ids and two runs, `solution` and `all-minerals`, ready for `formatLevel`. */
  readonly level: LevelFile;
  /** The run `solution`, [press, release) in ticks. */
  readonly holds: readonly Hold[];
  /** How robust `solution` is at `precise`. */
  readonly robustness: Robustness;
  /** How robust `solution` is at `arcade`. */
  readonly arcade: Robustness;
  /** The grade of the level, measured at `precise`. */
  readonly grade: Grade;
  /** How much the level is of the theme that was asked for; null without a theme. */
  readonly theme: ThemeMeasure | null;
  /** How symmetric the novae are; null where no symmetry was asked for, by an option or by the theme. */
  readonly symmetry: SymmetryMeasure | null;
  /** How many minerals `solution` does not collect. */
  readonly aside: number;
}

/** How much a level is of a theme. */
export interface ThemeMeasure {
  /** The theme. */
  readonly name: ThemeName;
  /** What is measured. */
  readonly measured: string;
  /** What the level measures, in the unit that `measured` says. */
  readonly value: number;
  /** The least that a level of the theme measures. */
  readonly least: number;
}

/** How symmetric the novae of a level are. */
export interface SymmetryMeasure {
  /** The kind that was asked for, or that the theme has. */
  readonly kind: SymmetryKind;
  /** The share of novae that have a counterpart. */
  readonly share: number;
}

/**
 * Why an attempt was given up: the asteroids did not fit; no run was good enough to build a level around; no minerals were found that
 * lead elsewhere; too little of the theme or of the symmetry is there; the level is too easy
 * and nothing makes it harder; it is too hard; its best run forgives too little; no minerals were found that one run collects; a
 * run does not hold under the asked terms; a warning is left.
 */
export type Rejection =
  | 'noRoom'
  | 'noRun'
  | 'noDetour'
  | 'offTheme'
  | 'asymmetric'
  | 'tooEasy'
  | 'tooHard'
  | 'unforgiving'
  | 'noMinerals'
  | 'outOfTerms'
  | 'warnings';

/** Every reason, in the order in which attempts meet them. */
export const REJECTIONS: readonly Rejection[] = [
  'noRoom',
  'noRun',
  'noDetour',
  'offTheme',
  'asymmetric',
  'tooEasy',
  'tooHard',
  'unforgiving',
  'noMinerals',
  'outOfTerms',
  'warnings',
];

/** An attempt at a level. It yields the ticks simulated since the last time, and returns a level, or why it failed. */
export type Attempt = Generator<number, Generated | Rejection>;
