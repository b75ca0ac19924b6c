import { useEffect, useState } from 'react';
import type { StoreApi } from 'zustand';

/** ms after which the update happens even without an idle moment */
const LONGEST = 150;

/** Calls back once the page is idle. @returns cancels it */
function whenIdle(call: () => void): () => void {
  // Safari has no requestIdleCallback
  if (typeof requestIdleCallback === 'undefined') {
    const timer = setTimeout(call, 30);
    return () => clearTimeout(timer);
  }
  const handle = requestIdleCallback(call, { timeout: LONGEST });
  return () => cancelIdleCallback(handle);
}

/**
 * Part of a store, which may lag a frame or two behind during fast changes. This leaves time for what must follow the pointer
 * at once. It is read at the time of the update.
 * @param pick stable between renders (`useCallback`, or defined outside the component)
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
