import type { AccuracyName } from '../../../engine/index.ts';
import type { Level } from '../../../schema/index.ts';
import type { Goal } from '../../../solver/index.ts';
import type { JobEnd, Results, Solving, Workers } from '../../workers/index.ts';
import type { SearchSettings } from './search-settings.ts';
import { withoutRuns } from './without-runs.ts';

/** Different runs that are looked for and shown. */
export const RUNS_WANTED = 5;

interface SearchTask {
  readonly level: Level;
  readonly accuracy: AccuracyName;
  readonly goal: Goal;
  readonly settings: SearchSettings;
}

interface SearchListener {
  /** What was found by now. */
  readonly onFound: (solving: Solving) => void;
  /** What was proved by now. */
  readonly onProved: (proved: Results['proofs']) => void;
  /** The search for runs is over; `onFound` has had all of it. */
  readonly onEnd: (end: JobEnd<'solve'>) => void;
}

/** The workers of a search: one looks for runs, another for proofs that there are none. */
export interface SearchJobs {
  /** Ends both; nothing is heard of them any more. */
  cancel(): void;
  /** Nothing is left to look for: ends the search for runs. */
  cancelSolving(): void;
}

export function startSearchJobs(
  workers: Pick<Workers, 'start'>,
  { level, accuracy, goal, settings }: SearchTask,
  { onFound, onProved, onEnd }: SearchListener,
): SearchJobs {
  let isOver = false;
  const played = { level: withoutRuns(level), accuracy };
  const { objective, seed, budget } = settings;
  // who asks for any run wants another one
  const known = objective === 'first' ? [] : level.runs.map(({ holds }) => holds);
  const solve = workers.start(
    'solve',
    { ...played, goal, objective, count: RUNS_WANTED, known, seed, lane: 0, budget: 1000 * budget },
    (solving) => {
      if (!isOver) onFound(solving);
    },
  );
  const prove = workers.start('proofs', { ...played, collected: [] }, (proved) => {
    if (!isOver) onProved(proved);
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
