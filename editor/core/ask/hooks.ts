import { useEffect, useState } from 'react';
import { type StoreApi, useStore } from 'zustand';
import { createStore } from 'zustand/vanilla';
import type { Asked, Desk, Question } from './question.ts';
import { afterRest, inPace, type Pace } from './waits.ts';

type Store<S> = Pick<StoreApi<S>, 'getState' | 'subscribe'>;

interface Following<S, T> {
  readonly store: Store<S>;
  readonly pick: (state: S) => T;
  /** What is shown until the first look; left out: the store is looked at at once. */
  readonly before?: T;
  /** Whether each change begins the wait again. */
  readonly restarts: boolean;
  readonly wait: (call: () => void) => () => void;
}

/** Part of a store, looked at again when `wait` calls back. */
function useSeen<S, T>({ store, pick, before, restarts, wait }: Following<S, T>): T {
  const look = () => ({ store, pick, value: before ?? pick(store.getState()) });
  const [seen, setSeen] = useState(look);
  // biome-ignore lint/correctness/useExhaustiveDependencies: how long it waits does not change
  useEffect(() => {
    let forget: (() => void) | null = null;
    const update = () => {
      forget = null;
      const value = pick(store.getState());
      setSeen((now) => (now.store === store && now.pick === pick && Object.is(now.value, value) ? now : { store, pick, value }));
    };
    const later = () => {
      if (restarts) forget?.();
      if (restarts || forget === null) forget = wait(update);
    };
    const stop = store.subscribe(later);
    if (restarts) later();
    else update();
    return () => {
      stop();
      forget?.();
    };
  }, [store, pick]);
  return seen.store === store && seen.pick === pick ? seen.value : look().value;
}

/**
 * Part of a store once nothing has changed for `ms`, for values too costly during a drag.
 * @param pick stable between renders (`useCallback`, or defined outside the component)
 * @param before what it is until the first rest; left out: the store is looked at at once
 */
export const useAtRest = <S, T>(store: Store<S>, pick: (state: S) => T, ms: number, before?: T): T =>
  useSeen({ store, pick, before, restarts: true, wait: (call) => afterRest(ms, call) });

/**
 * Part of a store, which may lag behind during fast changes. This leaves time for what must follow the pointer at once. It is read at
 * the time of the update, as the arrays of a proof are only valid until the next one.
 * @param pick stable between renders (`useCallback`, or defined outside the component)
 */
export const useInPace = <S, T>(store: Store<S>, pick: (state: S) => T, pace: Pace): T =>
  useSeen({ store, pick, restarts: false, wait: (call) => inPace(pace, call) });

/** What a promise resolves to, which `ask` makes of a value that stays the same; null until then, and after another value. */
export function usePromised<K, T>(of: K, ask: (of: K) => Promise<T>): T | null {
  const [known, setKnown] = useState<{ readonly of: K; readonly value: T } | null>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: it is asked once for each value
  useEffect(() => {
    let isGone = false;
    void ask(of).then((value) => !isGone && setKnown({ of, value }));
    return () => {
      isGone = true;
    };
  }, [of]);
  return known?.of === of ? known.value : null;
}

/** What a question follows that a component asks; null: nothing. */
export type Wanted<O> = Pick<StoreApi<O | null>, 'getState' | 'subscribe'>;

/**
 * Asks a question for as long as the component is there.
 * @param ask a question that follows what the component wants
 * @param of what it is about, the same value as long as it is the same; null: nothing is asked
 */
export function useQuestion<O, A, P>(
  ask: (desk: Desk, from: Wanted<O>) => Question<O, A, P>,
  desk: Desk,
  of: O | null,
): Asked<O, A, P> | null {
  const [wanted] = useState(() => createStore<O | null>(() => of));
  const [own, setOwn] = useState<Question<O, A, P> | null>(null);
  useEffect(() => {
    const asked = ask(desk, wanted);
    setOwn(asked);
    return asked.close;
  }, [ask, desk, wanted]);
  useEffect(() => wanted.setState(of, true), [wanted, of]);
  return useStore(own?.store ?? NONE) as Asked<O, A, P> | null;
}

const NONE = createStore<unknown>(() => null);
