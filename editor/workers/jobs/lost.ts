import { softlocksOf } from '../../../check/index.ts';
import { compile } from '../../../engine/index.ts';
import { createSoftlockSurvey, LIVES_ON, type RunLoss, type SoftlockSurvey, type SurveyedState } from '../../../solver/index.ts';
import type { Losing, Loss, Losses, LostMoment } from '../protocol.ts';
import { createPacer, type Start, type Work } from '../work.ts';

/** ms between two reports */
const TELL = 400;

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
  let told = now();
  while (!survey.finished && asked < effort) {
    pace((ticks) => {
      const more = Math.min(ticks, effort - asked);
      asked += more;
      survey.advance(more);
    });
    const isDue = now() - told >= TELL;
    if (isDue) told = now();
    yield isDue ? found(survey) : null;
  }
  return found(survey);
}

/** Examines where a level is already lost. */
export const lost: Start<'lost'> = ({ level, terms, effort }, now): Work<'lost'> =>
  examine(createSoftlockSurvey(compile(level, terms)), effort, now, toLosing);

/** Finds out since when runs were lost. */
export const losses: Start<'losses'> = ({ level, terms, traced, effort }, now): Work<'losses'> =>
  examine(createSoftlockSurvey(compile(level, terms), { traced, explores: false }), effort, now, toLosses);
