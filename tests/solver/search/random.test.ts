import { expect, it } from 'vitest';
import { createRandom } from '../../../solver/index.ts';

it('gives the numbers of sfc32 for ever: runs found for a seed must be found again', () => {
  const random = createRandom(1);
  const first = Array.from({ length: 4 }, () => random.next());
  const again = createRandom(1);
  expect(Array.from({ length: 4 }, () => again.next())).toEqual(first);
  expect(first).toMatchInlineSnapshot(`
    [
      441792574,
      614447336,
      1644328534,
      3387734806,
    ]
  `);
});

it('seeds that are close, distant, fractional or negative give unrelated numbers', () => {
  const seeds = [0, 1, 2, -1, 0.5, 4_294_967_296, 4_294_967_297, 9_007_199_254_740_991];
  expect(new Set(seeds.map((seed) => createRandom(seed).next())).size).toBe(seeds.length);
});

it('is evenly distributed', () => {
  const random = createRandom(7);
  const counts = new Array(10).fill(0);
  for (let i = 0; i < 100_000; i++) counts[random.below(10)]++;
  // Chi-square with 9 degrees of freedom: above 27.9 once in a thousand.
  const chi = counts.reduce((sum, n) => sum + (n - 10_000) ** 2 / 10_000, 0);
  expect(chi).toBeLessThan(27.9);
  for (let i = 0; i < 1000; i++) {
    const u = random.unit();
    expect(u >= 0 && u < 1).toBe(true);
  }
});

it('a fork is independent', () => {
  const parent = createRandom(3);
  const child = parent.fork();
  const own = Array.from({ length: 50 }, () => child.next());
  const after = Array.from({ length: 50 }, () => parent.next());
  expect(own.some((n) => after.includes(n))).toBe(false);
});
