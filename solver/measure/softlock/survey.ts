import { maxTicksOf, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import type { Effort } from '../../search/explore/index.ts';
import type { LostPlace, RunLoss, SurveyedState } from './standing.ts';
import { surveySteps } from './survey-steps.ts';
import { SurveyTask } from './survey-task.ts';
import { createTracedRun } from './trace-run.ts';

/** What {@link createSoftlockSurvey} examines. */
export interface SurveyOptions {
  /** Runs whose states are examined, too; those of the level by default. */
  readonly runs?: readonly (readonly Hold[])[];
  /** Runs that fail, such as attempts of players: since when each was lost is looked for before anything else. None by default. */
  readonly traced?: readonly (readonly Hold[])[];
  /** Whether states that a search reaches are examined as well, besides those of runs; true by default. */
  readonly explores?: boolean;
  /** Seed of the random choices, a whole number; 0 by default. */
  readonly seed?: number;
  /** The longest a run may last, ticks; that of the scene by default. */
  readonly maxTicks?: number;
}

/** An examination of where the level is already lost. It can be stopped at any time, and has its results so far. */
export interface SoftlockSurvey {
  /** The work done so far; what provers cost counts as ticks. */
  readonly effort: Effort;
  /** Every state that is examined. */
  readonly states: readonly SurveyedState[];
  /** The places where the level is lost although she lives on, those first where she lives on longest. */
  readonly places: readonly LostPlace[];
  /** Since when each of the traced runs was lost, in their order. */
  readonly losses: readonly RunLoss[];
  /** True when nothing more is examined. */
  readonly finished: boolean;
  /**
   * Continues the work. The same total gives the same result however it is split into calls. An attempt to prove begins once
   * all that it may take is asked for; less is done until then.
   * @param ticks how many more ticks to simulate; the survey may overshoot a little
   */
  advance(ticks: number): void;
}

/**
 * Creates an examination of the states in which she is alive, and from which the black hole cannot be reached any more. It
 * examines states along the level's runs and states that a search reaches. Nothing is simulated before the first call of
 * `advance`.
 *
 * Each state is searched from, first briefly, then longer and longer, and proved lost where a prover covers it, with ever finer
 * sets. A state is
 * called lost only with a proof or with the length of the search that found nothing. Where she lives on for a second and more,
 * the way back along the run is searched for the moment at which it was lost.
 * @param scene the compiled level
 * @param options runs, seed and the longest run
 * @returns a survey at its start
 * @example
 * ```ts
 * import { compile } from 'gravity-quest-toolkit';
 * import { createSoftlockSurvey } from 'gravity-quest-toolkit/solver';
 *
 * const survey = createSoftlockSurvey(compile(level));
 * survey.advance(3_000_000);
 * for (const { x, y, tick, alive, standing } of survey.places) console.log(x, y, tick, alive, standing.is);
 * ```
 */
export function createSoftlockSurvey(scene: Scene, options: SurveyOptions = {}): SoftlockSurvey {
  const { seed = 0, maxTicks = maxTicksOf(scene.terms), runs = scene.level.runs.map(({ holds }) => holds) } = options;
  const { explores = true } = options;
  const traced = (options.traced ?? []).map(createTracedRun);
  const task = new SurveyTask(scene, { runs, seed, maxTicks });
  const work = surveySteps(task, traced, explores);
  let asked = 0;
  let finished = false;
  return {
    get effort() {
      return { runs: task.runCount, ticks: task.ticks };
    },
    get states() {
      return task.states;
    },
    get places() {
      return task.losses.places();
    },
    get losses() {
      return traced;
    },
    get finished() {
      return finished;
    },
    advance(ticks) {
      asked += ticks;
      while (!finished && task.ticks + task.reserved < asked) finished = work.next().done === true;
    },
  };
}
