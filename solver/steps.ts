/** A long computation that yields after every few runs, so that the caller can pause, cancel or show progress. */
export type Steps<R> = Generator<null, R, void>;

/** Runs a computation to its end without pausing. */
export function finish<R>(steps: Steps<R>): R {
  for (;;) {
    const step = steps.next();
    if (step.done === true) return step.value;
  }
}

/** A computation that goes on only as far as work is asked for. */
interface Advancing {
  readonly finished: boolean;
  /** The same total gives the same result however it is split into calls. @param more work, in the unit of `spent` */
  readonly advance: (more: number) => void;
}

/** @param spent the work done so far, of which a step may do more than was asked for */
export function advancing(steps: Iterator<unknown>, spent: () => number): Advancing {
  let asked = 0;
  let finished = false;
  return {
    get finished() {
      return finished;
    },
    advance(more) {
      asked += more;
      while (!finished && spent() < asked) finished = steps.next().done === true;
    },
  };
}
