import { createStore, type StoreApi } from 'zustand/vanilla';
import { type Desk, question } from '../../ask/index.ts';
import { type FoundByWorker, type LiveProof, type ProofStore, toPlay } from '../../proof/index.ts';
import { type AskedOf, jobs } from '../../workers/index.ts';

/** What a worker found out about a level that the page does not simulate itself. */
export interface Checked extends FoundByWorker, AskedOf<typeof jobs.check> {}

export interface CheckWatch {
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

/** Follows the level: if the page has left something out, a worker simulates all of it once the level has settled. */
export function watchChecks({ proof, desk }: { readonly proof: ProofStore; readonly desk: Desk }): CheckWatch {
  const store = createStore<Checked | null>(() => null);
  const checks = checkQuestion(desk, proof);
  checks.store.subscribe(({ phase, of, answer, message }) => {
    if (of !== null && (phase === 'done' || phase === 'failed'))
      store.setState({ ...of, result: answer, message: message ?? '' }, true);
  });
  return { store, close: checks.close };
}

/**
 * The worker's result for a level of which the page has left something out; null if it left nothing out or the worker is not
 * done.
 */
export const checkedOf = (proof: Pick<LiveProof, 'level' | 'terms' | 'limit'>, checked: Checked | null): Checked | null =>
  proof.limit !== null && checked !== null && checked.level === proof.level && checked.terms === proof.terms ? checked : null;
