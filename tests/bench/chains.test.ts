import { describe, expect, it } from 'vitest';
import { compile, createSimulation, STATE_SIZE, simulate, TICK_RATE } from '../../engine/index.ts';
import { createRandom } from '../../solver/index.ts';
import { itDeep, someOf } from '../depth.ts';
import { FAMILIES, LONGEST_RUN, makeChain, makeGrazing, makeMirrored } from '../scenes/chains/index.ts';

describe.each(someOf(FAMILIES, 2))('a chain that is %s', (family) => {
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

itDeep('with minerals has some on its own run', () => {
  const { level, goal, holds } = makeChain('minerals', 4, 1);
  expect(level.minerals.length).toBe(2);
  expect(goal).toEqual({ minerals: 'all' });
  const { outcome, minerals } = simulate(compile(level, 'precise'), holds, { maxTime: LONGEST_RUN / TICK_RATE });
  expect(outcome).toBe('completed');
  expect(minerals.map(({ index }) => index)).toEqual([0, 1]);
});

describe('a hole that is grazed', () => {
  it('stands beyond the range, and a run reaches it in the last tick in range', () => {
    const { level, holds } = makeGrazing(0.1, 3);
    const { x, y } = level.blackHole;
    expect(Math.hypot(x, y)).toBeGreaterThan(250 + 18);
    expect(simulate(compile(level, 'precise'), holds).outcome).toBe('completed');
    const away = { ...level, blackHole: { ...level.blackHole, x: x * 1.01, y: y * 1.01 } };
    expect(simulate(compile(away, 'precise'), holds).outcome).toBe('lost');
  });
});

describe('a mirrored chain', () => {
  it('keeps the angular momentum about the nearest asteroid, whatever is pressed, until another one is nearest', () => {
    const level = makeMirrored(3);
    const wide = level.asteroids[1].x - level.asteroids[0].x;
    const simulation = createSimulation(compile({ ...level, novae: [] }, 'precise'));
    const state = new Float64Array(STATE_SIZE);
    const random = createRandom(1);
    let crossed = 0;
    for (let run = 0; run < 40; run++) {
      simulation.reset();
      simulation.readState(state);
      let [x, y, vx, vy] = state;
      let momentum = x * vy - y * vx;
      let asteroid = 0;
      while (simulation.tick < 1200 && simulation.ending === null) {
        simulation.advance(1 + random.below(40), random.unit() < 0.5);
        simulation.readState(state);
        [x, y, vx, vy] = state;
        const nearest = Math.min(3, Math.max(0, Math.round(x / wide)));
        const now = (x - nearest * wide) * vy - y * vx;
        if (nearest === asteroid) expect(now).toBeCloseTo(momentum, 6);
        else crossed++;
        asteroid = nearest;
        momentum = now;
      }
    }
    expect(crossed).toBeGreaterThan(20);
  });
});
