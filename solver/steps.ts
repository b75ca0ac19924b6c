/** Something that takes long, in steps of a run or few: it knows no clock, so whoever takes the steps says when it rests. */
export type Steps<R> = Generator<null, R, void>;

/** Takes all steps at once. */
export function finish<R>(steps: Steps<R>): R {
  for (;;) {
    const step = steps.next();
    if (step.done === true) return step.value;
  }
}
