import { maxTicksOf, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { createSearch, type Effort } from '../../search/explore/index.ts';
import { advancing, type Steps } from '../../steps.ts';
import { verifyRun } from '../../verified-run.ts';
import { proveLostByOrbits } from './prove-lost.ts';
import type { Examined, LostPlace, RunLoss, SurveyedState } from './state.ts';
import { SurveyTask } from './survey-task.ts';
import { createTracedRun, dateLoss, proveLoss, type TracedRun } from './trace-run.ts';

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
  const going = advancing(surveySteps(task, traced, explores), () => task.ticks + task.reserved);
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
      return going.finished;
    },
    advance: going.advance,
  };
}

/** Ticks between two states of one of the level's own runs. */
const STRIDE = 30;
/** At most so many of the level's own runs are examined. */
const MOST_RUNS = 8;

/** Ticks of the search that reaches states, and how many of them are examined. */
const EXPLORE = 100_000;
const REACHED = 120;
const SLICE = 2000;

/** Ticks of the searches from each state: the first, and another where that finds nothing. */
const FIRST_SEARCH = 10_000;
const SEARCH = 40_000;

/** She lives on if she was seen alive for this long after a state, ticks. */
export const LIVES_ON = 60;

/** The moment at which a run was lost is found up to this many ticks. */
const FINE = 3;
const FINE_PROVED = 8;
/** At most so many moments of either kind are looked for. */
const MOST_ENTRIES = 8;

/**
 * Rounds of longer searches from each state from which no run was found, ticks, and of finer proofs: the most that an attempt may
 * take, ticks.
 */
const ROUNDS: readonly { readonly search: number; readonly attempt: number }[] = [
  { search: 160_000, attempt: 2_000_000 },
  { search: 640_000, attempt: 8_000_000 },
  { search: 2_560_000, attempt: 24_000_000 },
];

/**
 * The work of a survey: dates the losses of the traced runs; gathers states, searches from each and tries to prove it lost, and
 * finds the moments at which they were lost. Then it searches longer from those that are not proved, and tries finer proofs.
 * @param explores whether states are examined that a search reaches
 */
function* surveySteps(task: SurveyTask, traced: readonly TracedRun[], explores: boolean): Steps<void> {
  yield* gatherOwn(task);
  for (const run of traced) yield* dateLoss(task, run, FIRST_SEARCH);
  for (const run of traced) yield* proveLoss(task, run);
  if (explores) yield* gatherReached(task);
  for (const state of byTick(task)) yield* task.searchFrom(state, FIRST_SEARCH);
  yield* proveLasting(task);
  yield* findEntries(task, 'proved', findProvedEntry);
  for (const run of traced) yield* dateLoss(task, run, SEARCH);
  for (const run of traced) yield* proveLoss(task, run);
  for (const state of byTick(task)) yield* task.searchFrom(state, SEARCH);
  yield* findEntries(task, 'not found', findEntry);
  for (const state of decisive(task, traced)) yield* task.prove(state, proveLostByOrbits);
  yield* findEntries(task, 'proved', findProvedEntry);
  for (const run of traced) yield* proveLoss(task, run);
  for (const { search, attempt } of ROUNDS) {
    for (const run of traced) yield* dateLoss(task, run, search);
    for (const state of byTick(task)) yield* task.searchFrom(state, search);
    // what was lost before may have turned out to be open, and the moment of loss is a later one
    task.losses.dropOpen();
    yield* findEntries(task, 'not found', findEntry);
    yield* proveFiner(task, traced, attempt);
    yield* findEntries(task, 'proved', findProvedEntry);
    for (const run of traced) yield* proveLoss(task, run);
  }
}

function* proveLasting(task: SurveyTask): Steps<void> {
  // the earliest first: what comes after a state that is proved lost is lost as well
  for (const state of byTick(task).reverse()) {
    // how she dies within a second does not matter
    if (state.alive >= LIVES_ON) yield* task.prove(state);
  }
}

/** The states to be proved: first the moments at which runs and places are lost, as they decide most, then the others. */
function decisive(task: SurveyTask, traced: readonly TracedRun[]): ReadonlySet<Examined> {
  const moments = [...traced.flatMap(({ lost }) => lost ?? []), ...task.losses.moments()];
  const lasting = byTick(task)
    .reverse()
    .filter(({ alive }) => alive >= LIVES_ON);
  return new Set([...moments, ...lasting]);
}

/** Tries finer proofs. @param most what an attempt may take, ticks */
function* proveFiner(task: SurveyTask, traced: readonly TracedRun[], most: number): Steps<void> {
  const states = decisive(task, traced);
  for (let isLeft = true; isLeft; ) {
    isLeft = false;
    for (const state of states) isLeft = (yield* task.proveLonger(state, most)) || isLeft;
  }
}

/** The latest first: a run that is found from a late state shows that the states before it are open. */
const byTick = ({ states }: SurveyTask): Examined[] => [...states].sort((a, b) => b.tick - a.tick);

/** The states along the level's own runs. */
function* gatherOwn(task: SurveyTask): Steps<void> {
  const { scene, maxTicks } = task;
  const runs = task.runs.slice(0, MOST_RUNS);
  for (const holds of runs) {
    const completed = verifyRun(scene, holds, { minerals: 'any' }, maxTicks);
    task.ticks += completed?.tick ?? maxTicks;
    if (completed !== null) task.complete(completed.holds);
    yield null;
  }
  for (const [run, holds] of runs.entries()) {
    for (let tick = 0; tick < maxTicks; tick += STRIDE) {
      const state = task.stateAt({ holds, tick }, run);
      if (state === null) break;
      task.states.push(state);
      yield null;
    }
  }
}

/** The states that a search reaches. */
function* gatherReached(task: SurveyTask): Steps<void> {
  const { scene, maxTicks } = task;
  const search = createSearch(scene, { seed: task.nextSeed(), maxTicks });
  while (search.effort.ticks < EXPLORE && !search.exhausted) {
    const before = search.effort.ticks;
    search.advance(SLICE);
    task.ticks += search.effort.ticks - before;
    yield null;
  }
  for (const { holds } of search.solutions) task.complete(holds);
  for (const moment of search.moments(REACHED)) {
    const state = task.stateAt(moment, null);
    if (state !== null) task.states.push(state);
    yield null;
  }
}

/** Finds, for lost states after which she lives on, the moments at which they were lost. */
function* findEntries(
  task: SurveyTask,
  is: 'proved' | 'not found',
  find: (task: SurveyTask, state: Examined) => Steps<void>,
): Steps<void> {
  const lasting = task.states.filter(({ standing, alive }) => standing.is === is && alive >= LIVES_ON);
  let found = 0;
  for (const state of lasting.sort((a, b) => b.alive - a.alive)) {
    const known = task.losses.of(state);
    if (known !== undefined) task.losses.follow(known, state);
    else if (found++ < MOST_ENTRIES) yield* find(task, state);
  }
}

/** Halves the time before a proved state, as long as the state between is proved, too. */
function* findProvedEntry(task: SurveyTask, state: Examined): Steps<void> {
  const open = task.lastOpen(state);
  let lost = state;
  let low = open ?? 0;
  while (lost.tick - low > FINE_PROVED) {
    const middle = task.stateAt({ holds: state.holds, tick: Math.floor((low + lost.tick) / 2) }, state.run);
    if (middle === null) break;
    middle.alive = lost.alive + lost.tick - middle.tick;
    yield* task.prove(middle);
    if (middle.standing.is === 'proved') lost = middle;
    else low = middle.tick;
  }
  task.losses.add(lost, open, state);
}

/**
 * Halves the time between the last moment at which the black hole could be reached and a state from which no run was found.
 * Whoever is lost stays lost, so there is one such moment on each way; only a search that is too short can miss it.
 */
function* findEntry(task: SurveyTask, state: Examined): Steps<void> {
  let open = task.lastOpen(state);
  let lost = state;
  let low = open ?? 0;
  while (lost.tick - low > FINE) {
    const middle = task.stateAt({ holds: state.holds, tick: Math.floor((low + lost.tick) / 2) }, state.run);
    if (middle === null) break;
    yield* task.searchFrom(middle, SEARCH);
    if (middle.standing.is === 'open') {
      low = middle.tick;
      open = middle.tick;
    } else lost = middle;
  }
  task.losses.add(lost, open, state);
}
