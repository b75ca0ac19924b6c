import { type Softlocks, softlocksOf } from '../../../check/index.ts';
import { compile } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { createSoftlockSurvey, LIVES_ON, type RunLoss, type SoftlockSurvey, type SurveyedState } from '../../../solver/index.ts';
import { createPacer, createReporting, job, type Played, type Work } from '../job.ts';

/** How it is known that a state is lost: by a proof, or only because no run was found. */
export type LostKnown = 'proved' | 'not found';

/** A state from which the black hole can't be reached any more, as far as is known. */
export interface LostMoment {
  /** px */
  readonly x: number;
  readonly y: number;
  readonly tick: number;
  readonly known: LostKnown;
  /** The reason of the proof; null without one. */
  readonly reason: string | null;
  /** How long the search was that found no run, ticks; null with a proof. */
  readonly searched: number | null;
}

/** A lost state, and the longest that she was seen alive after it, ticks. */
export interface LostState extends LostMoment {
  readonly alive: number;
}

/** Where a level is already lost, as far as it has been examined. */
export interface Losing {
  readonly counts: Softlocks['states'];
  /** Lost states after which she lives on for a second or more. */
  readonly states: readonly LostState[];
  /** Where such states begin, the longest life first. */
  readonly places: readonly LostState[];
  readonly ticks: number;
  readonly finished: boolean;
}

/** Where the level is already lost although she lives on, examined with so much effort, ticks. */
export const lost = job<Played & { readonly effort: number }, Losing, Losing>({ name: 'lost', lane: 'long', most: null });

/** Since when a run was lost, as far as is known. */
export interface Loss {
  /** The last tick at which she is alive. */
  readonly last: number;
  readonly completes: boolean;
  /** The last tick at which the black hole is known to be in reach; null if none is known. */
  readonly open: number | null;
  /** The first moment from which no run was found; null if none is known. */
  readonly lost: LostMoment | null;
  /** The first moment that is proved lost; null if none is. */
  readonly proved: LostMoment | null;
}

/** The losses of runs, in the order in which they were asked for. */
export interface Losses {
  readonly losses: readonly Loss[];
  readonly ticks: number;
  readonly finished: boolean;
}

/** Since when runs were lost that do not complete the level, with so much effort for all of them, ticks. */
export const losses = job<Played & { readonly traced: readonly (readonly Hold[])[]; readonly effort: number }, Losses, Losses>({
  name: 'losses',
  lane: 'long',
  most: null,
});

/** ms between two reports */
const REPORT = 400;

/** A state as plain data, without its proof, which can be large; null if it is not lost. */
function momentOf({ x, y, tick, standing }: SurveyedState): LostMoment | null {
  if (standing.is === 'proved') return { x, y, tick, known: 'proved', reason: standing.proof.reason, searched: null };
  return standing.is === 'not found' ? { x, y, tick, known: 'not found', reason: null, searched: standing.ticks } : null;
}

const lostAmong = (states: readonly SurveyedState[]): Losing['states'] =>
  states.flatMap((state) => {
    const moment = state.alive >= LIVES_ON ? momentOf(state) : null;
    return moment === null ? [] : [{ ...moment, alive: state.alive }];
  });

function toLosing(survey: SoftlockSurvey): Losing {
  const { states, places, effort, isFinished } = softlocksOf(survey);
  return {
    counts: states,
    states: lostAmong(survey.states),
    places: lostAmong(places),
    ticks: effort.ticks,
    finished: isFinished,
  };
}

const toLoss = ({ last, completes, open, lost, proved }: RunLoss): Loss => ({
  last,
  completes,
  open,
  lost: lost && momentOf(lost),
  proved: proved && momentOf(proved),
});

const toLosses = ({ losses, effort, finished }: SoftlockSurvey): Losses => ({
  losses: losses.map(toLoss),
  ticks: effort.ticks,
  finished,
});

/** Advances a survey until it is finished or the effort is spent, and reports what it has found so far. */
function* examine<T>(
  survey: SoftlockSurvey,
  effort: number,
  now: () => number,
  found: (survey: SoftlockSurvey) => T,
): Generator<T | null, T, void> {
  const pace = createPacer(now);
  let asked = 0;
  const isReportDue = createReporting(REPORT, now(), now);
  while (!survey.finished && asked < effort) {
    pace((ticks) => {
      const more = Math.min(ticks, effort - asked);
      asked += more;
      survey.advance(more);
    });
    yield isReportDue() ? found(survey) : null;
  }
  return found(survey);
}

/** Examines where a level is already lost. */
export const lostWork: Work<typeof lost> = {
  of: lost,
  steps: ({ level, terms, effort }, now) => examine(createSoftlockSurvey(compile(level, terms)), effort, now, toLosing),
};

/** Finds out since when runs were lost. */
export const lossesWork: Work<typeof losses> = {
  of: losses,
  steps: ({ level, terms, traced, effort }, now) =>
    examine(createSoftlockSurvey(compile(level, terms), { traced, explores: false }), effort, now, toLosses),
};
