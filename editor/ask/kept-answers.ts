import { createStore, type StoreApi } from 'zustand/vanilla';
import { type Asked, type AskedOnce, askOnce, type Desk, type Question } from './question.ts';

/** What is known, and what is asked at the moment; null: nothing. */
export interface Kept<W, V> {
  readonly byKey: ReadonlyMap<string, V>;
  readonly making: W | null;
}

/** Answers that are kept by what they depend on, so that nothing is asked twice. */
export interface KeptAnswers<W, V> {
  readonly store: StoreApi<Kept<W, V>>;
  /** Wants an answer unless it is there or waited for. */
  want(key: string, wanted: W): void;
  /** Withdraws what is not asked yet. */
  drop(key: string): void;
  /** Withdraws everything, and cancels what is asked. */
  stop(): void;
}

interface KeptOptions<W, O, A, P, V> {
  readonly ask: (desk: Desk, from: null) => Question<O, A, P>;
  /** What is asked; null: it can't be any more. */
  readonly of: (wanted: W, key: string) => O | null | Promise<O | null>;
  /** What is kept of an answer; null: nothing. */
  readonly value: (asked: Asked<O, A, P>, wanted: W, key: string) => V | null;
  /** Which of those that wait is asked first. */
  readonly first: 'latest' | 'earliest';
  /** So many are kept, the latest. */
  readonly most: number;
  /** Called with what is kept no longer. */
  readonly leaves?: (value: V) => void;
}

/** Keeps answers. They are asked for one at a time, so that other work does not have to wait for the workers. */
export function keepAnswers<W, O, A, P, V>(
  desk: Desk,
  { ask, of, value, first, most, leaves }: KeptOptions<W, O, A, P, V>,
  known: ReadonlyMap<string, V> = new Map(),
): KeptAnswers<W, V> {
  const store = createStore<Kept<W, V>>(() => ({ byKey: known, making: null }));
  const waiting = new Map<string, W>();
  let asking: AskedOnce<O, A, P> | null = null;
  /** Grows with every stop, so that what was begun before knows that it is over. */
  let turn = 0;

  const keep = (key: string, made: V) => {
    const byKey = new Map(store.getState().byKey).set(key, made);
    for (const [old, one] of byKey) {
      if (byKey.size <= most) break;
      byKey.delete(old);
      leaves?.(one);
    }
    store.setState({ byKey });
  };
  const make = async (key: string, wanted: W) => {
    const mine = turn;
    const about = await of(wanted, key);
    if (about === null || mine !== turn) return;
    asking = askOnce(ask, desk, about);
    const made = value(await asking.end, wanted, key);
    if (mine === turn && made !== null) keep(key, made);
  };
  const go = async () => {
    if (store.getState().making !== null) return;
    for (;;) {
      const next = first === 'latest' ? [...waiting].at(-1) : [...waiting][0];
      if (next === undefined) break;
      const [key, wanted] = next;
      waiting.delete(key);
      store.setState({ making: wanted });
      await make(key, wanted);
    }
    store.setState({ making: null });
  };
  return {
    store,
    want(key, wanted) {
      if (store.getState().byKey.has(key) || waiting.has(key)) return;
      waiting.set(key, wanted);
      void go();
    },
    drop: (key) => void waiting.delete(key),
    stop() {
      turn++;
      waiting.clear();
      asking?.stop();
    },
  };
}
