import type { Page } from 'playwright-core';

/**
 * Runs in a page before its own scripts.
 * Draws about 10 frames per second, not 60, which would use half a processor. While the clock is fast, a frame comes whenever a
 * playtest can go on by as much as it may at once, which is 0.25 s.
 * The clock of frames and `performance.now` can run faster or stand still: see `hurry` and `pass`. Timers and dates do not
 * change.
 */
export function paceFrames(): void {
  const now = performance.now.bind(performance);
  const clock = { rate: 1, real: 0, shown: 0 };
  const shownAt = (real: number) => clock.shown + (real - clock.real) * clock.rate;
  performance.now = () => shownAt(now());
  const ask = window.requestAnimationFrame.bind(window);
  /** What the next frame calls, in this order, as in every frame of a browser. */
  const waiting = new Map<number, FrameRequestCallback>();
  let last = 0;
  let timer: number | null = null;
  let isAsked = false;
  const draw = (real: number) => {
    isAsked = false;
    for (const id of [...waiting.keys()]) {
      const callback = waiting.get(id);
      waiting.delete(id);
      try {
        callback?.(shownAt(real));
      } catch (error) {
        reportError(error);
      }
    }
  };
  const schedule = () => {
    if (isAsked || waiting.size === 0) return;
    if (timer !== null) clearTimeout(timer);
    timer = window.setTimeout(
      () => {
        timer = null;
        isAsked = true;
        ask(draw);
      },
      Math.min(84, Math.max(0, 250 / Math.max(clock.rate, 1) - 16)),
    );
  };
  window.requestAnimationFrame = (callback) => {
    waiting.set(++last, callback);
    if (timer === null) schedule();
    return last;
  };
  window.cancelAnimationFrame = (id) => {
    waiting.delete(id);
  };

  const setRate = (rate: number) => {
    const real = now();
    Object.assign(clock, { rate, real, shown: shownAt(real) });
    // a frame that is already due comes at the new pace, too
    schedule();
  };
  const pass = (ms: number) => {
    clock.shown += ms;
  };
  Object.assign(window, { setRate, pass });
}

/**
 * Sets the pace of frames until the page is reloaded.
 * @param rate seconds of the frames' clock per second; 0: the clock stands still. A playtest advances at most 0.25 s per frame.
 */
export const hurry = (page: Page, rate: number): Promise<void> => page.evaluate(`setRate(${rate})`);

/** Advances the clock of the frames at once. */
export const pass = (page: Page, ms: number): Promise<void> => page.evaluate(`pass(${ms})`);

/** Waits for two frames, after which all changes are drawn. */
export const nextFrames = (page: Page): Promise<unknown> =>
  page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
