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

/** The page's own. */
export const pageTimers: Timers = {
  now: () => performance.now(),
  after(ms, call) {
    const id = setTimeout(call, ms);
    return () => clearTimeout(id);
  },
};
