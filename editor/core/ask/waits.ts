// The two ways in which the page waits: until the user rests, and in pace with what goes on.

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

/** How long to wait for an idle moment, ms. */
interface Idle {
  /** after this, the page is taken as idle even if it never is */
  readonly longest: number;
  /** where the browser can't tell, as Safari */
  readonly untold: number;
}

const NEXT_TURN: Idle = { longest: 150, untold: 30 };

/** Calls back once the page is idle. @returns cancels it */
export function whenIdle({ longest, untold }: Idle, call: () => void): () => void {
  if (typeof requestIdleCallback === 'undefined') return after(untold, call);
  const handle = requestIdleCallback(call, { timeout: longest });
  return () => cancelIdleCallback(handle);
}

/** Calls back after `ms`. @returns cancels it */
export function after(ms: number, call: () => void): () => void {
  const timer = setTimeout(call, ms);
  return () => clearTimeout(timer);
}

/** How often something follows a store at most: every so many ms, or whenever the page has nothing else to do. */
export type Pace = number | 'idle';

/** Calls back when the next turn is due. @returns cancels it */
export const inPace = (pace: Pace, call: () => void): (() => void) =>
  pace === 'idle' ? whenIdle(NEXT_TURN, call) : after(pace, call);
