import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Terms } from '../../../engine/index.ts';
import type { Level } from '../../../schema/index.ts';
import type { Goal, Objective } from '../../../solver/index.ts';
import { type Desk, onDemand } from '../../core/ask/index.ts';
import { withoutRuns } from '../../core/proof/index.ts';
import { jobs, type Proofs, type Solving } from '../../workers/index.ts';

/** Starts a search. */
export const SOLVE_KEY = '$mod+Enter';

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
  readonly onProved: (proved: Proofs) => void;
  /** Called when the search for runs has ended by itself, after the last `onFound`. @param failure null: it is done */
  readonly onEnd: (failure: string | null) => void;
}

/** The questions of a search: one looks for runs, the other for proofs that there are none. */
interface SearchJobs {
  /** Searches, in place of an earlier search. */
  start(task: SearchTask, listener: SearchListener): void;
  /** Cancels both; no listener is called any more. */
  cancel(): void;
  /** Cancels the search for runs, as nothing is left to find. */
  cancelSolving(): void;
}

/** Runs of a level. */
export const solveQuestion = onDemand(jobs.solve);

/** Whether there are none, with finer sets for as long as runs are searched. */
export const hopelessQuestion = onDemand(jobs.proofs);

export function createSearchJobs(desk: Desk): SearchJobs {
  const solving = solveQuestion(desk);
  const proving = hopelessQuestion(desk);
  const cancel = () => {
    solving.forget();
    proving.forget();
  };
  return {
    start({ level, terms, goal, settings }, { onFound, onProved, onEnd }) {
      cancel();
      let reports = 0;
      const played = { level: withoutRuns(level), terms };
      const { objective, seed, budget } = settings;
      // with the objective `first`, runs that the level already has count as well
      const known = objective === 'first' ? [] : level.runs.map(({ holds }) => holds);
      const task = { ...played, goal, objective, count: RUNS_WANTED, known, seed, lane: 0, budget: 1000 * budget };
      solving.ask(task, ({ phase, progress, answer, message }) => {
        const found = answer ?? progress;
        if (found !== null && phase !== 'failed') onFound(found);
        // first the black hole is reported, then the minerals; as it can be reached, finer sets would prove nothing
        if (phase === 'asking' && reports > 1 && found !== null && found.solutions.length > 0) proving.stop();
        if (phase !== 'asking') onEnd(message);
      });
      proving.ask({ ...played, collected: [], finer: 1000 * budget, isDrawn: true }, ({ phase, progress, answer }) => {
        if (phase === 'asking') reports++;
        const proved = answer ?? progress;
        if (proved !== null && phase !== 'failed') onProved(proved);
      });
    },
    cancel,
    cancelSolving: solving.stop,
  };
}

// what a person wants of a search

/** The settings of a search for runs. */
export interface SearchSettings {
  readonly minerals: 'any' | 'all' | 'some';
  /** the number for `some` */
  readonly some: number;
  readonly objective: Objective;
  /** s */
  readonly budget: number;
  readonly seed: number;
}

export type SearchSettingsStore = StoreApi<SearchSettings>;

export const createSearchSettings = (): SearchSettingsStore =>
  createStore<SearchSettings>(() => ({ minerals: 'any', some: 1, objective: 'robust', budget: 10, seed: 0 }));

/** The goal of a run. @param count minerals in the level */
export function goalOf({ minerals, some }: SearchSettings, count: number): Goal {
  if (minerals === 'some') return { minerals: Math.min(some, count) };
  // Without minerals in the level, all means any.
  return { minerals: minerals === 'all' && count > 0 ? 'all' : 'any' };
}

const AIMS: Readonly<Record<Objective, string>> = { robust: 'safest', presses: 'simplest', time: 'quickest', first: 'found' };

/** The name of a run found with these settings: `safest`, `all minerals, quickest`, `safest 2` for the second best. */
export function aimOf({ minerals, some, objective }: SearchSettings, place: number): string {
  const taken =
    minerals === 'all' ? ['all minerals'] : minerals === 'some' ? [`${some} ${some === 1 ? 'mineral' : 'minerals'}`] : [];
  // for runs with minerals, safest is the default and goes without saying
  const best = taken.length > 0 && (objective === 'robust' || objective === 'first') ? [] : [AIMS[objective]];
  return [...taken, ...best].join(', ') + (place > 1 ? ` ${place}` : '');
}
