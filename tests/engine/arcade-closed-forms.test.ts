import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, createSimulation, STATE_SIZE, TICK } from '../../engine/index.ts';
import { DEFAULT_RULES } from '../../schema/index.ts';
import { type PlainLevel, plainLevel } from './plain-level.ts';

const number = (min: number, max: number) => fc.integer({ min: min * 64, max: max * 64 }).map((k) => k / 64);

function stateAfter(level: PlainLevel, plan: readonly (readonly [ticks: number, held: boolean])[]) {
  const simulation = createSimulation(compile(plainLevel(level), 'arcade'));
  for (const [ticks, held] of plan) simulation.advance(ticks, held);
  const state = new Float64Array(STATE_SIZE);
  simulation.readState(state);
  return { x: state[0], y: state[1], vx: state[2], vy: state[3], cos: state[4], sin: state[5] };
}

describe('arcade, against the sums of semi-implicit Euler', () => {
  it('coasts by v dt per frame, with constant velocity', () => {
    fc.assert(
      fc.property(number(-100, 100), number(-100, 100), number(-900, 900), number(-900, 900), fc.nat(600), (x, y, vx, vy, n) => {
        const state = stateAfter({ astronaut: { x, y, vx, vy } }, [[n, false]]);
        expect([state.vx, state.vy, state.cos, state.sin]).toEqual([vx, vy, 1, 0]);
        expect(state.x).toBeCloseTo(x + n * vx * TICK, 8);
        expect(state.y).toBeCloseTo(y + n * vy * TICK, 8);
      }),
    );
  });

  it('in a field along a ray from its centre: a acts on v one frame later, on x in that frame, a dt^2 n (n - 1) / 2', () => {
    fc.assert(
      fc.property(number(1, 40), fc.integer({ min: 1, max: 300 }), (x, n) => {
        const state = stateAfter({ astronaut: { x }, repulsors: [{ x: 0, y: 0, radius: 1000 }] }, [[n, false]]);
        expect(state.vx).toBeCloseTo(DEFAULT_RULES.push * (n - 1) * TICK, 9);
        expect(state.x).toBeCloseTo(x + (DEFAULT_RULES.push * TICK * TICK * n * (n - 1)) / 2, 9);
        expect([state.y, state.vy]).toEqual([0, 0]);
      }),
    );
  });

  it('held towards one asteroid on a line: the linear recurrence of the pull', () => {
    fc.assert(
      fc.property(number(100, 200), number(300, 1000), fc.integer({ min: 1, max: 60 }), (distance, range, n) => {
        const asteroids = [{ x: distance, y: 0, radius: 16 }];
        const state = stateAfter({ asteroids, range }, [[n, true]]);
        // d after frame k, with the pull as of frame k - 1
        let [d, v, a] = [distance, 0, 0];
        for (let k = 0; k < n; k++) {
          v += a * TICK;
          a = DEFAULT_RULES.pull * (1 - d / range);
          d -= v * TICK;
        }
        expect(distance - state.x).toBeCloseTo(d, 9);
        expect(state.vx).toBeCloseTo(v, 9);
        expect([state.cos, state.sin]).toEqual([1, 0]);
      }),
    );
  });

  it('a press in frame f turns her in f, changes velocity in f + 1 and position at the end of f + 1', () => {
    const level = { asteroids: [{ x: 0, y: 100, radius: 16 }], range: 250 };
    const pull = DEFAULT_RULES.pull * (1 - 100 / 250);
    expect(stateAfter(level, [[5, false]])).toMatchObject({ y: 0, vy: 0, cos: 1, sin: 0 });
    expect(
      stateAfter(level, [
        [5, false],
        [1, true],
      ]),
    ).toMatchObject({ y: 0, vy: 0, cos: 0, sin: 1 });
    const next = stateAfter(level, [
      [5, false],
      [2, true],
    ]);
    expect(next.vy).toBeCloseTo(pull * TICK, 12);
    expect(next.y).toBeCloseTo(pull * TICK * TICK, 12);
    // a release in frame f likewise: the pull of frame f - 1 still acts in f
    const released = stateAfter(level, [
      [5, false],
      [1, true],
      [10, false],
    ]);
    expect(released.vy).toBeCloseTo(pull * TICK, 12);
    expect(released.y).toBeCloseTo(10 * pull * TICK * TICK, 12);
  });

  it('no component of the velocity exceeds the speed limit', () => {
    const level = { astronaut: { x: 50, vx: 990, vy: -999 }, repulsors: [{ x: 0, y: 0, radius: 1e6 }] };
    const state = stateAfter(level, [[300, false]]);
    expect(state.vx).toBe(DEFAULT_RULES.speedLimit);
    expect(state.vy).toBe(-DEFAULT_RULES.speedLimit);
  });
});
