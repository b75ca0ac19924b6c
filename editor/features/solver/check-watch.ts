import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Terms } from '../../../engine/index.ts';
import type { Level } from '../../../schema/index.ts';
import { type FoundByWorker, type LiveProof, toPlay } from '../../core/proof/index.ts';
import type { Job } from '../../workers/index.ts';
import type { WatchParts } from './proof-watch.ts';

/** What a worker found out about a level that the page does not simulate itself. */
export interface Checked extends FoundByWorker {
  readonly level: Level;
  readonly terms: Terms;
}

export interface CheckWatch {
  readonly store: StoreApi<Checked | null>;
  close(): void;
}

/** ms without a change: before that, the page itself tries with a larger limit */
const SETTLE = 700;

/** Follows the level: if the page has left something out, a worker simulates all of it once the level has settled. */
export function watchChecks({ level: { proof }, workers, afterRest }: WatchParts): CheckWatch {
  const store = createStore<Checked | null>(() => null);
  let job: Job<'check'> | null = null;
  let forget = () => {};
  const drop = () => {
    job?.cancel();
    job = null;
    forget();
  };
  const ask = () => {
    const question = toPlay(proof.proof());
    const known = store.getState();
    if (question === null || (known?.level === question.level && known.terms === question.terms)) return;
    const { level, terms } = question;
    const mine = workers.start('check', question);
    job = mine;
    void mine.end.then((end) => {
      if (job !== mine || end.kind === 'cancelled') return;
      const [result, message] = end.kind === 'done' ? [end.result, ''] : [null, end.message];
      store.setState({ level, terms, result, message }, true);
    });
  };
  const look = (now: LiveProof) => {
    drop();
    if (toPlay(now) !== null) forget = afterRest(SETTLE, ask);
  };
  look(proof.proof());
  const stop = proof.store.subscribe(look);
  return {
    store,
    close() {
      stop();
      drop();
    },
  };
}

/**
 * The worker's result for a level of which the page has left something out; null if it left nothing out or the worker is not
 * done.
 */
export const checkedOf = (proof: Pick<LiveProof, 'level' | 'terms' | 'limit'>, checked: Checked | null): Checked | null =>
  proof.limit !== null && checked !== null && checked.level === proof.level && checked.terms === proof.terms ? checked : null;
