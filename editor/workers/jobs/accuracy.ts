import { ACCURACIES } from '../../../engine/index.ts';
import {
  type Compared,
  compareAll,
  type Deviation,
  METHODS,
  type Reference,
  withCosts,
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
export interface ComparedSettings<S> extends Pick<Reference, 'knownTo' | 'doubt'>, Pick<Compared, 'unmeasured'> {
  readonly settings: readonly S[];
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

/** Of all runs together, ms. */
const BUDGET = { named: { comparing: 4000, timing: 800, most: 4000 }, all: { comparing: 8000, timing: 3000, most: 9000 } };

export const accuracyWork: Work<typeof accuracy> = {
  of: accuracy,
  *steps({ level, terms: { maxTime, maxWork }, runs, methods }, now) {
    yield null;
    const { comparing, timing, most } = BUDGET[methods];
    const options = {
      maxTime,
      maxWork,
      now,
      budget: { comparing: comparing / runs.length, timing: timing / runs.length, most: most / runs.length },
      methods: methods === 'named' ? Object.values(ACCURACIES) : METHODS,
    };
    const compared: Compared[] = [];
    for (const holds of runs) {
      compared.push(compareAll(level, holds, options));
      yield compared.length === runs.length ? compared.map(errorsOf) : null;
    }
    const measured: ComparedSettings<Setting>[] = [];
    for (const [i, holds] of runs.entries()) {
      const { methods: timed, ...rest } = withCosts(level, holds, compared[i], options);
      const errors = errorsOf({ ...rest, methods: timed });
      measured.push({ ...errors, settings: errors.settings.map((one, k) => ({ ...one, cost: timed[k].cost.minimum })) });
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
    unmeasured,
  };
}
