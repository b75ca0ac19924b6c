// What the page computes itself is done in slices: it draws and responds between them, and what is stopped is not heard of again.

import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { inSlices } from '../../editor/core/ask/index.ts';

/** Counts to a number; each step takes so many ms. */
function* counting(to: number, ms: number): Generator<number, string, void> {
  for (let i = 1; i <= to; i++) {
    now += ms;
    yield i;
  }
  return 'done';
}

let now = 0;

beforeEach(() => {
  now = 0;
  vi.useFakeTimers();
  vi.spyOn(performance, 'now').mockImplementation(() => now);
});

afterEach(() => {
  vi.restoreAllMocks();
  vi.useRealTimers();
});

describe('work in slices', () => {
  it('begins after its wait, does as many steps as fit into a slice, and ends with its answer', () => {
    const slices: (readonly number[])[] = [];
    const onDone = vi.fn();
    inSlices(counting(5, 3), { wait: 100, slice: 6, onSlice: (made) => slices.push(made), onDone });
    vi.advanceTimersByTime(99);
    expect(slices).toEqual([]);
    vi.advanceTimersByTime(1);
    expect(slices).toEqual([[1, 2]]);
    vi.runAllTimers();
    expect(slices).toEqual([[1, 2], [3, 4], [5]]);
    expect(onDone.mock.calls).toEqual([['done']]);
  });

  it('does one step a slice where a slice has no length', () => {
    const slices: (readonly number[])[] = [];
    inSlices(counting(3, 0), { wait: 0, slice: 0, onSlice: (made) => slices.push(made) });
    vi.runAllTimers();
    expect(slices).toEqual([[1], [2], [3], []]);
  });

  it.each([
    ['before it begins', 0],
    ['between two slices', 1],
    ['at a slice', 2],
  ])('is not heard of once it was stopped %s', (_, slices) => {
    const heard: number[] = [];
    const onDone = vi.fn();
    let seen = 0;
    const stop = inSlices(counting(3, 0), {
      wait: 10,
      slice: 0,
      onSlice(made) {
        heard.push(...made);
        if (++seen === 2 && slices === 2) stop();
      },
      onDone,
    });
    if (slices === 1) vi.advanceTimersByTime(10);
    if (slices < 2) stop();
    vi.runAllTimers();
    expect(heard).toEqual([1, 2].slice(0, slices));
    expect(onDone).not.toHaveBeenCalled();
    expect(vi.getTimerCount()).toBe(0);
  });
});
