import type { OwnRules } from '../schema/basics/index.ts';
import { ACCURACIES, type Accuracy, type AccuracyName, DEFAULT_ACCURACY, validAccuracy } from './accuracy.ts';
import { DEFAULT_MAX_TIME, TICK_RATE } from './constants.ts';
import { DEFAULT_MAX_WORK } from './work-budget.ts';

/**
 * Under which terms something is said about a level. They are made once, of options, configuration and defaults, and a
 * {@link Scene} carries them, so that whatever is asked about it is asked under the same terms. Plain data.
 */
export interface Terms {
  /** How exactly the level is simulated. */
  readonly accuracy: Accuracy;
  /** The longest a run may last, s of simulated time; a longer run ends with `timeout`. */
  readonly maxTime: number;
  /** The work that one level may cost, pieces of motion. */
  readonly maxWork: number;
  /** The rules of the folder, which hold where a level sets none of its own. */
  readonly rules: OwnRules;
}

/** The terms that hold where nothing else is said. */
export const DEFAULT_TERMS: Terms = {
  accuracy: ACCURACIES[DEFAULT_ACCURACY],
  maxTime: DEFAULT_MAX_TIME,
  maxWork: DEFAULT_MAX_WORK,
  rules: {},
};

/**
 * The longest a run may last under some terms.
 *
 * @param terms - the terms
 * @returns whole ticks of 1/60 s
 */
export const maxTicksOf = ({ maxTime }: Pick<Terms, 'maxTime'>): number => Math.round(maxTime * TICK_RATE);

/**
 * The terms that a name, an accuracy or terms stand for: with an accuracy alone, the other terms are {@link DEFAULT_TERMS}.
 *
 * @param under - the name of an accuracy, an accuracy, or terms
 * @returns the terms
 * @throws {RangeError} when the accuracy is none, a custom setting contradicts itself, or a limit is not positive
 */
export function termsOf(under: AccuracyName | Accuracy | Terms): Terms {
  if (typeof under === 'object' && under !== null && 'accuracy' in under) {
    for (const limit of ['maxTime', 'maxWork'] as const)
      if (!(under[limit] > 0)) throw new RangeError(`terms, ${limit}: expected more than 0, found ${under[limit]}`);
    const accuracy = validAccuracy(under.accuracy);
    return accuracy === under.accuracy ? under : { ...under, accuracy };
  }
  return { ...DEFAULT_TERMS, accuracy: validAccuracy(under) };
}

/**
 * What some terms set otherwise than {@link DEFAULT_TERMS}, apart from rules.
 *
 * @param terms - the terms, with the name of the accuracy alone
 * @returns only what differs
 */
export function unusualTerms({
  accuracy,
  maxTime,
  maxWork,
}: {
  readonly accuracy: string;
  readonly maxTime: number;
  readonly maxWork: number;
}): {
  readonly accuracy?: string;
  readonly maxTime?: number;
  readonly maxWork?: number;
} {
  return {
    ...(accuracy !== DEFAULT_TERMS.accuracy.name && { accuracy }),
    ...(maxTime !== DEFAULT_TERMS.maxTime && { maxTime }),
    ...(maxWork !== DEFAULT_TERMS.maxWork && { maxWork }),
  };
}
