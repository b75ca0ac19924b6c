/** A clock with callbacks: the page's, or one that a test controls. */
export interface Timers {
  /** ms, from an arbitrary origin */
  now(): number;
  /** Calls back after `ms`. @returns cancels it */
  after(ms: number, call: () => void): () => void;
}

/** Waits for a promise, but at most `ms`. */
export async function atMost(ms: number, promise: Promise<unknown>, timers: Timers): Promise<void> {
  let cancel = () => {};
  const late = new Promise<void>((resolve) => {
    cancel = timers.after(ms, resolve);
  });
  await Promise.race([promise, late]);
  cancel();
}

/** A call that is made at most once per interval, however often it is requested. */
export interface Throttled {
  /** Requests the call: it is made after a while, unless `now` comes first. */
  soon(): void;
  /** Makes the call now, if it was requested. */
  now(): void;
}

/** @param ms the longest delay of a call */
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

/** The timers of the page. */
export const pageTimers: Timers = {
  now: () => performance.now(),
  after(ms, call) {
    const id = setTimeout(call, ms);
    return () => clearTimeout(id);
  },
};
