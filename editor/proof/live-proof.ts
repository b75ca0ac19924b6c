import { createStore, type StoreApi } from 'zustand/vanilla';
import type { AccuracyName } from '../../engine/index.ts';
import type { EditedLevel } from '../document/index.ts';
import { createProver, type LiveProof } from './prover.ts';

/** The proof of the open level, up to date after every change. */
export interface ProofStore {
  readonly store: StoreApi<LiveProof>;
  proof(): LiveProof;
  /** Which run is shown; the first one when it is null or there is none of that name. */
  showRun(name: string | null): void;
  setAccuracy(accuracy: AccuracyName): void;
  /** Stops following the level. */
  close(): void;
}

/** Follows a level: its proof is made anew within every change, so that one frame shows both. */
export function createProofStore(level: EditedLevel, accuracy: AccuracyName, run: string | null = null): ProofStore {
  const prover = createProver();
  let asked = { run, accuracy };
  const prove = () => prover.prove({ file: level.file(), ...asked });
  const store = createStore<LiveProof>(prove);
  const update = () => store.setState(prove(), true);
  return {
    store,
    proof: () => store.getState(),
    showRun(name) {
      asked = { ...asked, run: name };
      update();
    },
    setAccuracy(name) {
      asked = { ...asked, accuracy: name };
      update();
    },
    close: level.subscribe(update),
  };
}
