/** Frames that have to begin: when the first one to come begins, what there is to show is made ready; when the next one does, it has been handed to the painter. */
const FRAMES = 2;
/** Where no frames are shown, as in a tab behind others, the wait for them is given up, ms. */
const NO_FRAME = 1000;

interface Waiting {
  readonly ms: number;
  readonly call: () => void;
  frames: number;
  timer: ReturnType<typeof setTimeout> | null;
}

// all that waits shares one request: in a drag every move of the pointer asks anew, from several places
const waiting = new Set<Waiting>();
let isAsked = false;

function ask(): void {
  isAsked = true;
  const frame = requestAnimationFrame(() => {
    clearTimeout(late);
    begin(1);
  });
  const late = setTimeout(() => {
    cancelAnimationFrame(frame);
    begin(FRAMES);
  }, NO_FRAME);
}

function begin(frames: number): void {
  isAsked = false;
  for (const one of waiting) {
    one.frames += frames;
    if (one.frames < FRAMES) continue;
    waiting.delete(one);
    one.timer = setTimeout(one.call, one.ms);
  }
  if (waiting.size > 0) ask();
}

/**
 * Calls back once the page has shown what there is to show and so many ms have gone by since: where frames take long, a drag goes on between two of them
 * though nothing has happened for a while.
 * @returns takes it back
 */
export function afterRest(ms: number, call: () => void): () => void {
  const one: Waiting = { ms, call, frames: 0, timer: null };
  waiting.add(one);
  if (!isAsked) ask();
  return () => {
    waiting.delete(one);
    if (one.timer !== null) clearTimeout(one.timer);
  };
}
