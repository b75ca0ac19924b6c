import { createStore, type StoreApi } from 'zustand/vanilla';
import { type Asked, type Desk, question } from '../../ask/index.ts';
import { type LiveProof, type ProofStore, type Proved, toProve } from '../../proof/index.ts';
import { jobs, type Proofs } from '../../workers/index.ts';

export interface ProofWatch {
  /** What is proved about the current level; empty while not known. */
  readonly store: StoreApi<Proved>;
  close(): void;
}

const NOTHING: Proved = { impossible: null, minerals: [], gaveUp: null };

/**
 * What no run reaches, the black hole or a mineral. What a run of the level reaches is not searched for a proof. It waits for the
 * robustness, which matters to the user more often.
 */
export const proofQuestion = question({
  job: jobs.proofs,
  request: toProve,
  follows: {
    wait: { rest: 500 },
    of: (proof: ProofStore): LiveProof => proof.proof(),
    // runs may come and go: a proof holds for all of them
    same: (asked, now) => asked.scene === now.scene,
    on: (proof) => [proof.store.subscribe],
  },
});

function provedBy({ phase, progress, answer, message, gaveUp }: Asked<LiveProof, Proofs, Proofs>): Proved {
  // everything is reached, so there is nothing to prove
  if (phase === 'nothing') return { ...NOTHING, isWhole: true };
  if (answer !== null) return { ...answer, gaveUp: null, isWhole: true };
  const soFar = progress === null ? NOTHING : { ...progress, gaveUp: null };
  return gaveUp ? { ...soFar, gaveUp: message } : soFar;
}

/** Follows the level: once it has settled, tries to prove that the black hole or a mineral is out of reach. */
export function watchProofs({ proof, desk }: { readonly proof: ProofStore; readonly desk: Desk }): ProofWatch {
  const proofs = proofQuestion(desk, proof);
  const store = createStore<Proved>(() => provedBy(proofs.store.getState()));
  proofs.store.subscribe((now) => {
    const proved = provedBy(now);
    if (proved !== store.getState()) store.setState(proved, true);
  });
  return { store, close: proofs.close };
}
