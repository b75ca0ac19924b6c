import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Scene } from '../../../engine/index.ts';
import { type Difficulty, mineralsNeeded } from '../../../solver/index.ts';
import { type Desk, onDemand } from '../../core/ask/index.ts';
import type { OpenLevel } from '../../core/context/index.ts';
import { withoutRuns } from '../../core/proof/index.ts';
import { jobs } from '../../workers/index.ts';
import { askedInWords } from './search-summary.ts';
import { goalOf, type SearchSettingsStore } from './search-task.ts';

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
  readonly level: Pick<OpenLevel, 'proof'>;
  readonly desk: Desk;
  readonly settings: SearchSettingsStore;
}

/** How hard a level is. */
export const difficultyQuestion = onDemand(jobs.difficulty);

/** Measures how hard the level is, on demand: with the shown run if it meets the goal, else with a run found by a search. */
export function createDifficultySession({ level: { proof }, desk, settings }: DifficultyParts): DifficultySession {
  const store = createStore<DifficultyState>(() => ({
    phase: 'idle',
    message: null,
    result: null,
    run: null,
    asked: '',
    isOld: false,
  }));
  const difficulty = difficultyQuestion(desk);
  let measured: { scene: Scene; holds: string } | null = null;
  const stop = proof.store.subscribe(({ scene, run }) => {
    if (measured === null || store.getState().isOld) return;
    if (scene !== measured.scene || run.holds.join() !== measured.holds) store.setState({ isOld: true });
  });
  return {
    store,
    start() {
      difficulty.forget();
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
      const about = { level: withoutRuns(level), terms, holds: completes ? run.holds : null, goal, budget };
      difficulty.ask(about, ({ phase, answer, message }) => {
        if (phase === 'failed') store.setState({ phase, message });
        else if (phase === 'done') store.setState({ phase: answer === null ? 'none' : 'done', result: answer });
      });
    },
    cancel() {
      difficulty.forget();
      store.setState(({ result }) => ({ phase: result === null ? 'idle' : 'done' }));
    },
    close() {
      stop();
      difficulty.forget();
    },
  };
}
