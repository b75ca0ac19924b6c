import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Problem } from '../../../schema/index.ts';
import { type AskedOf, jobs, type Proofs } from '../../workers/index.ts';
import { type Asked, type Desk, question } from '../ask/index.ts';
import {
  type FoundByWorker,
  knownProblems,
  type LiveProof,
  type ProofStore,
  type Proved,
  toPlay,
  toProve,
} from '../proof/index.ts';

// What workers find out about the open level once it rests: runs that the page does not simulate, proofs that something is out of reach.

/** What a worker found out about a level that the page does not simulate itself. */
interface Checked extends FoundByWorker, AskedOf<typeof jobs.check> {}

export interface CheckWatch {
  /** null: nothing is known */
  readonly store: StoreApi<Checked | null>;
  close(): void;
}

/** All runs of a level of which the page has left something out. Before that, the page itself tries with a larger limit. */
export const checkQuestion = question({
  job: jobs.check,
  request: (of: AskedOf<typeof jobs.check>) => of,
  follows: {
    wait: { rest: 700 },
    of: (proof: ProofStore) => toPlay(proof.proof()),
    same: (asked, now) => asked.level === now.level && asked.terms === now.terms,
    on: (proof) => [proof.store.subscribe],
  },
});

/** Follows the level: if the page has left something out, a worker simulates all of it once the level rests. */
export function watchChecks({ proof, desk }: { readonly proof: ProofStore; readonly desk: Desk }): CheckWatch {
  const store = createStore<Checked | null>(() => null);
  const checks = checkQuestion(desk, proof);
  checks.store.subscribe(({ phase, of, answer, message }) => {
    if (of !== null && (phase === 'done' || phase === 'failed'))
      store.setState({ ...of, result: answer, message: message ?? '' }, true);
  });
  return { store, close: checks.close };
}

/** The worker's result for the level as it is; null if the page left nothing out or the worker is not done. */
export const checkedOf = (proof: Pick<LiveProof, 'level' | 'terms' | 'limit'>, checked: Checked | null): Checked | null =>
  proof.limit !== null && checked !== null && checked.level === proof.level && checked.terms === proof.terms ? checked : null;

/** The problems of a level as far as they are known; `line` and `column` are null. */
export const problemsKnown = (
  known: Pick<LiveProof, 'findings' | 'level' | 'terms' | 'limit'>,
  checked: Checked | null,
  proved: Proved,
): readonly Problem[] => knownProblems(known, checkedOf(known, checked), proved);

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

/** Follows the level: once it rests, tries to prove that the black hole or a mineral is out of reach. */
export function watchProofs({ proof, desk }: { readonly proof: ProofStore; readonly desk: Desk }): ProofWatch {
  const proofs = proofQuestion(desk, proof);
  const store = createStore<Proved>(() => provedBy(proofs.store.getState()));
  proofs.store.subscribe((now) => {
    const proved = provedBy(now);
    if (proved !== store.getState()) store.setState(proved, true);
  });
  return { store, close: proofs.close };
}
