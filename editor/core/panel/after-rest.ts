/**
 * Frames to wait for: when the first begins, the pending changes are rendered; when the second begins, they have been handed to
 * the painter.
 */
const FRAMES = 2;
/** Without frames, as in a background tab, the wait for them ends after this time, ms. */
const NO_FRAME = 1000;

interface Waiting {
  readonly ms: number;
  readonly call: () => void;
  frames: number;
  timer: ReturnType<typeof setTimeout> | null;
}

// All waiting calls share one request: in a drag, every move of the pointer asks again, from several places.
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
 * Calls back once the page has shown its pending changes and `ms` have passed since. A plain timer would not do: with slow
 * frames, a drag may go on between two of them although nothing seems to have happened for a while.
 * @returns cancels it
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
