import type { Terms } from '../../../engine/index.ts';
import type { Level } from '../../../schema/index.ts';
import type { Goal } from '../../../solver/index.ts';
import { withoutRuns } from '../../proof/index.ts';
import { type JobEnd, jobs, type Results, type Solving, type Workers } from '../../workers/index.ts';
import type { SearchSettings } from './search-settings.ts';

/** the number of different runs that a search looks for */
export const RUNS_WANTED = 5;

interface SearchTask {
  readonly level: Level;
  readonly terms: Terms;
  readonly goal: Goal;
  readonly settings: SearchSettings;
}

interface SearchListener {
  /** Called with what has been found so far. */
  readonly onFound: (solving: Solving) => void;
  /** Called with what has been proved so far. */
  readonly onProved: (proved: Results['proofs']) => void;
  /** Called when the search for runs has ended, after the last `onFound`. */
  readonly onEnd: (end: JobEnd<Solving>) => void;
}

/** The workers of a search: one looks for runs, the other for proofs that there are none. */
export interface SearchJobs {
  /** Cancels both; no listener is called any more. */
  cancel(): void;
  /** Cancels the search for runs, as nothing is left to find. */
  cancelSolving(): void;
}

export function startSearchJobs(
  workers: Pick<Workers, 'start'>,
  { level, terms, goal, settings }: SearchTask,
  { onFound, onProved, onEnd }: SearchListener,
): SearchJobs {
  let isOver = false;
  let areMineralsProved = false;
  const played = { level: withoutRuns(level), terms };
  const { objective, seed, budget } = settings;
  // with the objective `first`, runs that the level already has count as well
  const known = objective === 'first' ? [] : level.runs.map(({ holds }) => holds);
  const solve = workers.start(
    jobs.solve,
    { ...played, goal, objective, count: RUNS_WANTED, known, seed, lane: 0, budget: 1000 * budget },
    (solving) => {
      if (isOver) return;
      onFound(solving);
      // the black hole can be reached, so finer sets would prove nothing
      if (solving.solutions.length > 0 && areMineralsProved) prove.cancel();
    },
  );
  let told = 0;
  const prove = workers.start(jobs.proofs, { ...played, collected: [], finer: 1000 * budget }, (proved) => {
    if (isOver) return;
    onProved(proved);
    // first the black hole is reported, then the minerals
    areMineralsProved = ++told > 1;
  });
  void solve.end.then((end) => {
    if (isOver) return;
    if (end.kind === 'done') onFound(end.result);
    onEnd(end);
  });
  void prove.end.then((end) => {
    if (!isOver && end.kind === 'done') onProved(end.result);
  });
  return {
    cancel() {
      isOver = true;
      solve.cancel();
      prove.cancel();
    },
    cancelSolving: () => solve.cancel(),
  };
}
