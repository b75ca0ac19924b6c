import type { Verdict } from '../../schema/index.ts';
import type { CheckedPack } from '../pack-file/index.ts';
import type { CheckedLevel } from './checked-level.ts';

/** What reports say about all levels of a check together. */
export interface Totals {
  levels: number;
  /** The number of levels for each verdict; 0 for verdicts that no level has. */
  readonly summary: Record<Verdict, number>;
  /** Levels that are completable and have no error. */
  good: number;
  /** Files that could not be read, and levels on which gq failed. */
  failed: number;
  warnings: number;
  /** Problems that levels allow. */
  allowed: number;
  /** Levels that forgive less than is required. */
  tight: number;
  /** Levels that are not as agreed on in the lock. */
  differing: number;
  /** Errors in the order of a pack. */
  packErrors: number;
}

const noLevels = (): Totals => ({
  levels: 0,
  summary: { completable: 0, broken: 0, unproven: 0, impossible: 0, invalid: 0, crashed: 0 },
  good: 0,
  failed: 0,
  warnings: 0,
  allowed: 0,
  tight: 0,
  differing: 0,
  packErrors: 0,
});

const isOfLock = (code: string): boolean => code === 'result-changed' || code === 'not-in-lock';

/** Whether a level is completable and has no error. */
export const isGood = ({ verdict, problems }: Pick<CheckedLevel, 'verdict' | 'problems'>): boolean =>
  verdict === 'completable' && problems.every(({ severity }) => severity === 'warning');

/** @param packs the pack files that were checked with the levels */
export function totalsOf(levels: Iterable<CheckedLevel>, packs: readonly CheckedPack[] = []): Totals {
  const totals = noLevels();
  for (const { problems, unreadable } of packs) {
    const errors = problems.filter(({ severity }) => severity === 'error').length;
    totals.packErrors += errors;
    totals.warnings += problems.length - errors;
    if (unreadable) totals.failed++;
  }
  for (const level of levels) {
    const { verdict, problems, unreadable, allowed = 0 } = level;
    totals.levels++;
    totals.summary[verdict]++;
    if (isGood(level)) totals.good++;
    if (unreadable || verdict === 'crashed') totals.failed++;
    totals.warnings += problems.filter(({ severity }) => severity === 'warning').length;
    totals.allowed += allowed;
    if (problems.some(({ code }) => code === 'slack-below-required')) totals.tight++;
    if (problems.some(({ code, severity }) => severity === 'error' && isOfLock(code))) totals.differing++;
  }
  return totals;
}

/** That there are more warnings than allowed; null if there are not. @param maxWarnings null: any number is allowed */
export function tooManyWarnings({ warnings }: Pick<Totals, 'warnings'>, maxWarnings: number | null): string | null {
  if (maxWarnings === null || warnings <= maxWarnings) return null;
  return `${warnings} ${warnings === 1 ? 'warning' : 'warnings'}: at most ${maxWarnings} allowed (--max-warnings)`;
}

/**
 * 2: nothing was checked, a file could not be read or gq failed; else 1: a level is not completable or has errors, the order of a
 * pack has errors, or there are too many warnings; else 0
 * @param maxWarnings null: any number is allowed
 */
export function exitCodeFor(totals: Totals, maxWarnings: number | null): 0 | 1 | 2 {
  const { levels, good, failed, packErrors } = totals;
  if (levels === 0 || failed > 0) return 2;
  return good === levels && packErrors === 0 && tooManyWarnings(totals, maxWarnings) === null ? 0 : 1;
}

/** The exit code of a check of these levels. */
export const exitCodeOf = (levels: readonly CheckedLevel[], maxWarnings: number | null): 0 | 1 | 2 =>
  exitCodeFor(totalsOf(levels), maxWarnings);
