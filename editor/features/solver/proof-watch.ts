import { createStore, type StoreApi } from 'zustand/vanilla';
import { type ProofStore, type Proved, toProve } from '../../core/proof/index.ts';
import type { Job, Workers } from '../../workers/index.ts';

export interface ProofWatch {
  /** What is proved about the current level; empty while not known. */
  readonly store: StoreApi<Proved>;
  close(): void;
}

/** What the watchers of the open level need. */
export interface WatchParts {
  readonly level: { readonly proof: ProofStore };
  readonly workers: Pick<Workers, 'start'>;
  /** Calls back once the page has been at rest for `ms`. @returns cancels it */
  readonly afterRest: (ms: number, call: () => void) => () => void;
}

/** ms without a change before proofs are searched: after robustness, which matters to the user more often */
const SETTLE = 500;

const NOTHING: Proved = { impossible: null, minerals: [], gaveUp: null };

/**
 * Follows the level: once it has settled, tries to prove that the black hole or a mineral is out of reach. What a run reaches
 * is not searched for a proof.
 */
export function watchProofs({ level: { proof }, workers, afterRest }: WatchParts): ProofWatch {
  const store = createStore<Proved>(() => NOTHING);
  let job: Job<'proofs'> | null = null;
  let forget: (() => void) | null = null;
  let last: object | null = null;

  const drop = () => {
    job?.cancel();
    job = null;
    forget?.();
    forget = null;
  };
  const prove = () => {
    forget = null;
    const question = toProve(proof.proof());
    if (question === null) {
      // everything is reached, so there is nothing to prove
      store.setState({ ...NOTHING, isWhole: true }, true);
      return;
    }
    const mine = workers.start('proofs', question, (proved) => {
      if (job === mine) store.setState({ ...proved, gaveUp: null }, true);
    });
    job = mine;
    void mine.end.then((end) => {
      if (job !== mine) return;
      if (end.kind === 'done') store.setState({ ...end.result, gaveUp: null, isWhole: true }, true);
      else if (end.kind === 'gaveUp') store.setState({ gaveUp: end.message });
    });
  };
  const look = () => {
    const { scene } = proof.proof();
    // Runs may come and go: a proof holds for all of them.
    if (scene === last) return;
    last = scene;
    drop();
    if (store.getState() !== NOTHING) store.setState(NOTHING, true);
    forget = afterRest(SETTLE, prove);
  };
  look();
  const stop = proof.store.subscribe(look);
  return {
    store,
    close() {
      stop();
      drop();
    },
  };
}
