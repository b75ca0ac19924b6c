import { ACCURACIES } from '../../../engine/index.ts';
import {
  type Compared,
  compareAll,
  costsOf,
  type Deviation,
  METHODS,
  type Reference,
} from '../../../engine/work-precision/index.ts';
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

/** How settings differ from the reference of a run. */
export interface ComparedSettings<S> extends Pick<Reference, 'knownTo' | 'doubt'> {
  readonly settings: readonly S[];
  /** Settings at which the run takes more work than allowed, and until when they played it, s. */
  readonly unmeasured: readonly { readonly name: string; readonly time: number }[];
}

export interface SettingsAsked extends Played {
  /** The holds of each run. */
  readonly runs: readonly (readonly Hold[])[];
  readonly methods: 'named' | 'all';
}

/** Errors, and then also costs, of the named or of all settings for some runs of this level. */
export const accuracy = job<SettingsAsked, readonly ComparedSettings<Setting>[], readonly ComparedSettings<SettingError>[]>({
  name: 'accuracy',
  lane: 'long',
  most: 60_000,
});

/** ms for the timing */
const BUDGET = { named: 800, all: 3000 };

export const accuracyWork: Work<typeof accuracy> = {
  of: accuracy,
  *steps({ level, terms: { maxTime, maxWork }, runs, methods }, now) {
    yield null;
    const options = {
      maxTime,
      maxWork,
      now,
      budget: BUDGET[methods] / runs.length,
      methods: methods === 'named' ? Object.values(ACCURACIES) : METHODS,
    };
    const compared: Compared[] = [];
    for (const holds of runs) {
      compared.push(compareAll(level, holds, options));
      yield compared.length === runs.length ? compared.map(errorsOf) : null;
    }
    const measured: ComparedSettings<Setting>[] = [];
    for (const [i, holds] of runs.entries()) {
      const costs = costsOf(level, holds, compared[i], options);
      const errors = errorsOf(compared[i]);
      measured.push({ ...errors, settings: errors.settings.map((one, k) => ({ ...one, cost: costs[k].minimum })) });
      yield null;
    }
    return measured;
  },
};

function errorsOf({ reference: { knownTo, doubt }, methods, unmeasured }: Compared): ComparedSettings<SettingError> {
  return {
    knownTo,
    doubt,
    settings: methods.map(({ accuracy: { name }, error, outcome, with: touched, time, sameVerdict }) => {
      return { name, error, outcome, with: touched, time, sameVerdict };
    }),
    unmeasured: unmeasured.map(({ accuracy: { name }, time }) => ({ name, time })),
  };
}
