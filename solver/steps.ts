/** A long computation that yields after every few runs, so that the caller can pause, cancel or show progress. */
export type Steps<R> = Generator<null, R, void>;

/** Runs a computation to its end without pausing. */
export function finish<R>(steps: Steps<R>): R {
  for (;;) {
    const step = steps.next();
    if (step.done === true) return step.value;
  }
}
