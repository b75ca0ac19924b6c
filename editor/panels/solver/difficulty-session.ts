import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Scene } from '../../../engine/index.ts';
import { type Difficulty, mineralsNeeded } from '../../../solver/index.ts';
import type { ProofStore } from '../../proof/index.ts';
import { withoutRuns } from '../../proof/index.ts';
import { jobs, type Results, type Running, type Workers } from '../../workers/index.ts';
import { goalOf, type SearchSettingsStore } from './search-settings.ts';
import { askedInWords } from './standing.ts';

export interface DifficultyState {
  /** `none`: there is no run to measure */
  readonly phase: 'idle' | 'measuring' | 'done' | 'none' | 'failed';
  readonly message: string | null;
  readonly result: Difficulty | null;
  /** The name of the measured run; null for a run found by a search. */
  readonly run: string | null;
  /** The goal besides the black hole: ` with all 3 minerals`; '' for none. */
  readonly asked: string;
  /** Whether the level or the run has changed since. */
  readonly isOld: boolean;
}

export interface DifficultySession {
  readonly store: StoreApi<DifficultyState>;
  start(): void;
  cancel(): void;
  close(): void;
}

interface DifficultyParts {
  readonly level: { readonly proof: ProofStore };
  readonly workers: Pick<Workers, 'start'>;
  readonly settings: SearchSettingsStore;
}

/** Measures how hard the level is, on demand: with the shown run if it meets the goal, else with a run found by a search. */
export function createDifficultySession({ level: { proof }, workers, settings }: DifficultyParts): DifficultySession {
  const store = createStore<DifficultyState>(() => ({
    phase: 'idle',
    message: null,
    result: null,
    run: null,
    asked: '',
    isOld: false,
  }));
  let job: Running<Results['difficulty']> | null = null;
  let measured: { scene: Scene; holds: string } | null = null;
  const stop = proof.store.subscribe(({ scene, run }) => {
    if (measured === null || store.getState().isOld) return;
    if (scene !== measured.scene || run.holds.join() !== measured.holds) store.setState({ isOld: true });
  });
  const cancel = () => {
    job?.cancel();
    job = null;
  };
  return {
    store,
    start() {
      cancel();
      const { level, terms, run, scene } = proof.proof();
      const goal = goalOf(settings.getState(), level.minerals.length);
      const asked = askedInWords(settings.getState(), level.minerals.length);
      // only a run that meets the goal can be measured
      const completes =
        run.name !== null &&
        run.outcome === 'completed' &&
        new Set(run.minerals.map(({ index }) => index)).size >= mineralsNeeded(goal, level.minerals.length);
      measured = { scene, holds: run.holds.join() };
      store.setState({ phase: 'measuring', message: null, isOld: false, run: completes ? run.name : null, asked });
      const budget = 1000 * settings.getState().budget;
      const mine = workers.start(jobs.difficulty, {
        level: withoutRuns(level),
        terms,
        holds: completes ? run.holds : null,
        goal,
        budget,
      });
      job = mine;
      void mine.end.then((end) => {
        if (job !== mine) return;
        if (end.kind === 'failed') store.setState({ phase: 'failed', message: end.message });
        else if (end.kind === 'done') store.setState({ phase: end.result === null ? 'none' : 'done', result: end.result });
      });
    },
    cancel() {
      cancel();
      store.setState(({ result }) => ({ phase: result === null ? 'idle' : 'done' }));
    },
    close() {
      stop();
      cancel();
    },
  };
}
