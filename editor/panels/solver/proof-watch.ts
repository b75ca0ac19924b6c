import { createStore, type StoreApi } from 'zustand/vanilla';
import { type ProofStore, type Proved, toProve } from '../../proof/index.ts';
import type { Job, Workers } from '../../workers/index.ts';

export interface ProofWatch {
  /** What is proved of the level as it is; nothing while that is not known. */
  readonly store: StoreApi<Proved>;
  close(): void;
}

/** What a watch of the open level needs. */
export interface WatchParts {
  readonly level: { readonly proof: ProofStore };
  readonly workers: Pick<Workers, 'start'>;
  /** Calls back once the page has rested for so many ms. @returns takes it back */
  readonly afterRest: (ms: number, call: () => void) => () => void;
}

/** ms without a change before proofs are looked for: later than what the run forgives, which is looked at more */
const SETTLE = 500;

const NOTHING: Proved = { impossible: null, minerals: [], gaveUp: null };

/** Follows the level: whenever it has settled, it is tried to prove that the black hole or a mineral is out of reach. What a run shows needs no proof. */
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
    if (question === null) return;
    const mine = workers.start('proofs', question, (proved) => {
      if (job === mine) store.setState({ ...proved, gaveUp: null }, true);
    });
    job = mine;
    void mine.end.then((end) => {
      if (job !== mine) return;
      if (end.kind === 'done') store.setState({ ...end.result, gaveUp: null }, true);
      else if (end.kind === 'gaveUp') store.setState({ gaveUp: end.message });
    });
  };
  const look = () => {
    const { scene } = proof.proof();
    // runs may come and go: what is proved holds for all of them
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
