import { describe, expect, it } from 'vitest';
import { FAMILIES, LONGEST_RUN, makeChain } from '../../bench/chains/index.ts';
import { compile, simulate, TICK_RATE } from '../../engine/index.ts';

describe.each(FAMILIES)('a chain that is %s', (family) => {
  it('is completed by its own run, and has one gap in each wall', () => {
    const { level, holds } = makeChain(family, 2, 1);
    const maxTime = LONGEST_RUN / TICK_RATE;
    expect(simulate(compile(level, 'precise'), holds, { maxTime }).outcome).toBe('completed');
    const xs = [...new Set(level.novae.map(({ x }) => x))].sort((a, b) => a - b);
    expect(xs.length).toBe(2);
    for (const x of xs) {
      const ys = level.novae.filter((nova) => nova.x === x).sort((a, b) => a.y - b.y);
      const gaps = ys.slice(1).map((nova, i) => nova.y - nova.radius - (ys[i].y + ys[i].radius));
      expect(gaps.filter((gap) => gap > 0)).toEqual([52]);
      expect(ys[0].y - ys[0].radius).toBeLessThan(-265);
      expect((ys.at(-1)?.y ?? 0) + (ys.at(-1)?.radius ?? 0)).toBeGreaterThan(265);
    }
  });
});

it('is the same level each time', () => {
  expect(makeChain('straight', 2, 1)).toEqual(makeChain('straight', 2, 1));
});
