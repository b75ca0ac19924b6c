import { LIVES_ON, type LostPlace, type SoftlockSurvey } from '../solver/index.ts';

/** What a survey found about states in which it is already lost. Plain data. */
export interface Softlocks {
  /** How many states were examined, and what is known of how many of them. */
  readonly states: {
    readonly examined: number;
    readonly open: number;
    readonly proved: number;
    readonly notFound: number;
    readonly unknown: number;
  };
  /** Of these the lost ones after which she was seen alive for a second and more. */
  readonly lasting: { readonly proved: number; readonly notFound: number };
  /** Where such states begin, the longest life first. */
  readonly places: readonly LostPlace[];
  readonly effort: { readonly runs: number; readonly ticks: number };
  readonly isFinished: boolean;
}

/** The findings of a survey, finished or not. */
export function softlocksOf(survey: SoftlockSurvey): Softlocks {
  const { states } = survey;
  const count = (is: string, alive = 0): number =>
    states.filter((state) => state.standing.is === is && state.alive >= alive).length;
  return {
    states: {
      examined: states.length,
      open: count('open'),
      proved: count('proved'),
      notFound: count('not found'),
      unknown: count('unknown'),
    },
    lasting: { proved: count('proved', LIVES_ON), notFound: count('not found', LIVES_ON) },
    places: survey.places,
    effort: { ...survey.effort },
    isFinished: survey.finished,
  };
}
