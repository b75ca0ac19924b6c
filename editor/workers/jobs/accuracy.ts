import { ACCURACIES } from '../../../engine/index.ts';
import { compareAll, costsOf, type Deviation, METHODS, type Reference } from '../../../engine/work-precision/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { job, type Played, type Work } from '../job.ts';

/** How far a setting is from the reference. */
export interface SettingError extends Pick<Deviation, 'error' | 'outcome' | 'with' | 'time' | 'sameVerdict'> {
  readonly name: string;
}

/** One setting in a work-precision diagram. */
export interface Setting extends SettingError {
  /** microseconds per simulated second */
  readonly cost: number;
}

/** How settings differ from a reference. */
export interface ComparedSettings<S> extends Pick<Reference, 'knownTo' | 'doubt'> {
  readonly settings: readonly S[];
}

export interface SettingsAsked extends Played {
  readonly holds: readonly Hold[];
  readonly methods: 'named' | 'all';
}

/** Errors, and then also costs, of the named or of all settings for this level and run. */
export const accuracy = job<SettingsAsked, ComparedSettings<Setting>, ComparedSettings<SettingError>>({
  name: 'accuracy',
  lane: 'long',
  most: 60_000,
});

/** ms for the timing */
const BUDGET = { named: 800, all: 3000 };

export const accuracyWork: Work<typeof accuracy> = {
  of: accuracy,
  *steps({ level, terms: { maxTime, maxWork }, holds, methods }, now) {
    yield null;
    const options = {
      maxTime,
      maxWork,
      now,
      budget: BUDGET[methods],
      methods: methods === 'named' ? Object.values(ACCURACIES) : METHODS,
    };
    const compared = compareAll(level, holds, options);
    const { knownTo, doubt } = compared.reference;
    const settings = compared.methods.map(({ accuracy: { name }, error, outcome, with: touched, time, sameVerdict }) => ({
      name,
      error,
      outcome,
      with: touched,
      time,
      sameVerdict,
    }));
    yield { knownTo, doubt, settings };
    const costs = costsOf(level, holds, compared, options);
    return { knownTo, doubt, settings: settings.map((setting, i) => ({ ...setting, cost: costs[i].minimum })) };
  },
};
