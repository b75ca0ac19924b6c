/** Requests that are served one after the other, the latest first. */
export interface OneAtATime<T> {
  has(key: string): boolean;
  /** Asks for something; it is served once nothing later waits. */
  want(key: string, wanted: T): void;
  /** Withdraws a request that is not served yet. */
  drop(key: string): void;
}

/** Serves requests one at a time, so that other work does not have to wait for the workers. @param make never rejects */
export function oneAtATime<T>(make: (key: string, wanted: T) => Promise<void>): OneAtATime<T> {
  const waiting = new Map<string, T>();
  let isBusy = false;
  const go = async () => {
    if (isBusy) return;
    isBusy = true;
    for (;;) {
      const last = [...waiting].at(-1);
      if (last === undefined) break;
      waiting.delete(last[0]);
      await make(...last);
    }
    isBusy = false;
  };
  return {
    has: (key) => waiting.has(key),
    want(key, wanted) {
      waiting.set(key, wanted);
      void go();
    },
    drop: (key) => void waiting.delete(key),
  };
}
