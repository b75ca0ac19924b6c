import { createSearch } from '../search/index.ts';
import type { Steps } from '../steps.ts';
import { verifyRun } from '../verified-run.ts';
import type { Examined, SurveyTask } from './survey-task.ts';

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
 * The work of a survey: gathers states, searches from each and tries to prove it lost, and finds the moments at which they were
 * lost; then it searches longer from those that are not proved.
 */
export function* surveySteps(task: SurveyTask): Steps<void> {
  yield* gather(task);
  for (const state of byTick(task)) yield* task.searchFrom(state, FIRST_SEARCH);
  // the earliest first: what comes after a state that is proved lost is lost as well
  for (const state of byTick(task).reverse()) {
    // how she dies within a second does not matter
    if (state.alive >= LIVES_ON) yield* task.prove(state);
  }
  yield* findEntries(task, 'proved', findProvedEntry);
  for (const state of byTick(task)) yield* task.searchFrom(state, SEARCH);
  yield* findEntries(task, 'not found', findEntry);
}

/** The latest first: a run that is found from a late state shows that the states before it are open. */
const byTick = ({ states }: SurveyTask): Examined[] => [...states].sort((a, b) => b.tick - a.tick);

function* gather(task: SurveyTask): Steps<void> {
  const { scene, maxTicks } = task;
  for (const [run, holds] of task.runs.slice(0, MOST_RUNS).entries()) {
    const completed = verifyRun(scene, holds, { minerals: 'any' }, maxTicks);
    task.ticks += completed?.tick ?? maxTicks;
    if (completed !== null) task.complete(completed.holds);
    for (let tick = 0; tick < (completed?.tick ?? maxTicks); tick += STRIDE) {
      const state = task.stateAt({ holds, tick }, run);
      if (state === null) break;
      task.states.push(state);
      yield null;
    }
  }
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
    const known = task.entryOf(state);
    if (known !== undefined) task.follow(known, state);
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
  task.enter(lost, open, state);
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
  task.enter(lost, open, state);
}
