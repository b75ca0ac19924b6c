import { useEffect, useState } from 'react';
import type { StoreApi } from 'zustand';

/** Later than this what waits for an idle moment is done anyway, ms. */
const LONGEST = 150;

/** Calls back once the page has nothing more urgent to do. @returns takes it back */
function whenIdle(call: () => void): () => void {
  // Safari has no idle moments
  if (typeof requestIdleCallback === 'undefined') {
    const timer = setTimeout(call, 30);
    return () => clearTimeout(timer);
  }
  const handle = requestIdleCallback(call, { timeout: LONGEST });
  return () => cancelIdleCallback(handle);
}

/**
 * Part of a store, a frame or two behind it while things change fast: for what may follow the pointer at some distance, so that what must follow it at once
 * can. It is picked from the state of that moment.
 * @param pick kept between renders (`useCallback`, or outside of the component)
 */
export function useWhenIdle<S, T>(store: Pick<StoreApi<S>, 'getState' | 'subscribe'>, pick: (state: S) => T): T {
  const look = () => ({ store, pick, value: pick(store.getState()) });
  const [picked, setPicked] = useState(look);
  useEffect(() => {
    let forget: (() => void) | null = null;
    const update = () => {
      forget = null;
      const value = pick(store.getState());
      setPicked((now) =>
        now.store === store && now.pick === pick && Object.is(now.value, value) ? now : { store, pick, value },
      );
    };
    const stop = store.subscribe(() => {
      forget ??= whenIdle(update);
    });
    update();
    return () => {
      stop();
      forget?.();
    };
  }, [store, pick]);
  return picked.store === store && picked.pick === pick ? picked.value : look().value;
}
