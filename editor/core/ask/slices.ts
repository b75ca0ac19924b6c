import { after } from './waits.ts';

interface Slices<S, A> {
  /** ms before the first slice */
  readonly wait: number;
  /** ms of work in a slice, at least one step; 0: one step a slice */
  readonly slice: number;
  /** Called after each slice, with what its steps have yielded. */
  readonly onSlice?: (made: readonly S[]) => void;
  readonly onDone?: (answer: A) => void;
}

/**
 * Work that the page does itself, in slices: between them it draws and responds. What is longer belongs to a worker.
 * @returns stops it: nothing is called after this
 */
export function inSlices<S, A>(
  steps: Generator<S, A, void>,
  { wait, slice, onSlice = () => {}, onDone = () => {} }: Slices<S, A>,
): () => void {
  let isStopped = false;
  const go = () => {
    const end = performance.now() + slice;
    const made: S[] = [];
    let step = steps.next();
    while (step.done !== true) {
      made.push(step.value);
      if (performance.now() >= end) break;
      step = steps.next();
    }
    onSlice(made);
    if (isStopped) return;
    if (step.done === true) onDone(step.value);
    else cancel = after(0, go);
  };
  let cancel = after(wait, go);
  return () => {
    isStopped = true;
    cancel();
  };
}
