/** A clock that can be asked to call back: the page's, or one that a test turns. */
export interface Timers {
  /** ms, from any moment on */
  now(): number;
  /** Calls back after so many ms. @returns takes the request back */
  after(ms: number, call: () => void): () => void;
}

/** Waits for a promise, but no longer than so many ms. */
export async function atMost(ms: number, promise: Promise<unknown>, timers: Timers): Promise<void> {
  let cancel = () => {};
  const late = new Promise<void>((resolve) => {
    cancel = timers.after(ms, resolve);
  });
  await Promise.race([promise, late]);
  cancel();
}

/** A call that is worth making now and then, and not each time there is a reason. */
export interface Throttled {
  /** There is a reason: it is made after a while, if it is not made before. */
  soon(): void;
  /** Makes it now, if there was a reason. */
  now(): void;
}

/** @param ms the most that a call waits */
export function throttled(ms: number, call: () => void, timers: Timers): Throttled {
  let cancel: (() => void) | null = null;
  const now = () => {
    if (cancel === null) return;
    cancel();
    cancel = null;
    call();
  };
  return {
    soon() {
      cancel ??= timers.after(ms, now);
    },
    now,
  };
}

/** The page's own. */
export const pageTimers: Timers = {
  now: () => performance.now(),
  after(ms, call) {
    const id = setTimeout(call, ms);
    return () => clearTimeout(id);
  },
};
