import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { afterRest } from '../../editor/ask/index.ts';

/** Requested frames, which the test runs. */
function stageFrames() {
  const asked = new Map<number, () => void>();
  let last = 0;
  vi.stubGlobal('requestAnimationFrame', (call: () => void) => {
    asked.set(++last, call);
    return last;
  });
  vi.stubGlobal('cancelAnimationFrame', (id: number) => asked.delete(id));
  return {
    asked,
    frame() {
      const calls = [...asked.values()];
      asked.clear();
      for (const call of calls) call();
    },
  };
}

describe('a call that waits until the page rests', () => {
  let frames: ReturnType<typeof stageFrames>;
  beforeEach(() => {
    vi.useFakeTimers();
    frames = stageFrames();
  });
  afterEach(() => {
    vi.runAllTimers();
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });

  it('is made the given ms after the second frame, however long that takes', () => {
    const call = vi.fn();
    afterRest(100, call);
    vi.advanceTimersByTime(500);
    frames.frame();
    vi.advanceTimersByTime(500);
    expect(call).not.toHaveBeenCalled();
    frames.frame();
    vi.advanceTimersByTime(99);
    expect(call).not.toHaveBeenCalled();
    vi.advanceTimersByTime(1);
    expect(call).toHaveBeenCalledTimes(1);
    vi.advanceTimersByTime(10_000);
    expect(call).toHaveBeenCalledTimes(1);
    expect(frames.asked.size).toBe(0);
  });

  it.each([0, 1, 2])('is not made if it is cancelled after %i frames, which does not affect others', (count) => {
    const [dropped, other] = [vi.fn(), vi.fn()];
    const forget = afterRest(100, dropped);
    afterRest(100, other);
    for (let i = 0; i < count; i++) frames.frame();
    forget();
    for (let i = count; i < 2; i++) frames.frame();
    vi.advanceTimersByTime(100);
    expect(dropped).not.toHaveBeenCalled();
    expect(other).toHaveBeenCalledTimes(1);
  });

  it('shares frames with others; a later one waits for two more', () => {
    const [early, late] = [vi.fn(), vi.fn()];
    afterRest(100, early);
    frames.frame();
    afterRest(100, late);
    expect(frames.asked.size).toBe(1);
    frames.frame();
    vi.advanceTimersByTime(100);
    expect([early.mock.calls.length, late.mock.calls.length]).toEqual([1, 0]);
    frames.frame();
    vi.advanceTimersByTime(100);
    expect(late).toHaveBeenCalledTimes(1);
  });

  it('is also made if no frames are shown', () => {
    const call = vi.fn();
    afterRest(100, call);
    vi.advanceTimersByTime(1099);
    expect(call).not.toHaveBeenCalled();
    vi.advanceTimersByTime(1);
    expect(call).toHaveBeenCalledTimes(1);
    expect(frames.asked.size).toBe(0);
  });
});
