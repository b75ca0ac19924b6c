import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type PlainState, plainLoop, plainScene } from '../../bench/plain-loop.ts';
import { referenceEnd } from '../../bench/reference.ts';
import { compile, createSimulation, joinHolds, playScript } from '../../engine/index.ts';
import { type Hold, type Level, resolveLevel } from '../../schema/index.ts';
import { asteroidField, FALL, fallDistance, ORBIT, TWELVE_CIRCLES } from '../scenes/index.ts';

function playArcade(level: Level, holds: readonly Hold[], ticks: number) {
  const simulation = createSimulation(compile(level, 'arcade'));
  playScript(simulation, holds, ticks);
  const state = new Float64Array(6);
  simulation.readState(state);
  const outcome = { none: 0, lost: 1, completed: 2, collided: 3 }[simulation.ending?.outcome ?? 'none'];
  return [simulation.tick, outcome, ...state];
}

function playPlain(level: Level, holds: readonly Hold[], ticks: number) {
  const out: PlainState = { frame: 0, outcome: 0, x: 0, y: 0, vx: 0, vy: 0, cos: 0, sin: 0 };
  plainLoop(plainScene(level, holds), ticks, out);
  return [out.frame, out.outcome, out.x, out.y, out.vx, out.vy, out.cos, out.sin];
}

const place = fc.record({ x: fc.integer({ min: -250, max: 250 }), y: fc.integer({ min: -250, max: 250 }) });
const circle = fc.record({
  x: fc.integer({ min: -400, max: 400 }),
  y: fc.integer({ min: -400, max: 400 }),
  radius: fc.constantFrom(16, 32),
});
const scenes = fc.record({
  astronaut: fc.record({
    x: fc.integer({ min: -99, max: 99 }),
    y: fc.integer({ min: -99, max: 99 }),
    vx: fc.integer({ min: -60, max: 60 }),
    vy: fc.integer({ min: -60, max: 60 }),
  }),
  blackHole: place,
  asteroids: fc.array(
    fc.tuple(circle, fc.boolean()).map(([c, hot]) => ({ ...c, hot })),
    { minLength: 1, maxLength: 8 },
  ),
  novae: fc.array(circle, { maxLength: 4 }),
  times: fc.uniqueArray(fc.integer({ min: 0, max: 900 }), { minLength: 2, maxLength: 20 }),
});

describe('the plain loop', () => {
  it('plays every scene of its rules to the bits of arcade', () => {
    fc.assert(
      fc.property(scenes, ({ times, ...objects }) => {
        const level = resolveLevel({ version: 1, name: 'Any', ...objects });
        const sorted = times.sort((a, b) => a - b);
        const pairs = Array.from({ length: Math.floor(sorted.length / 2) }, (_, i): Hold => [sorted[2 * i], sorted[2 * i + 1]]);
        const holds = joinHolds(pairs);
        expect(playPlain(level, holds, 1200)).toEqual(playArcade(level, holds, 1200));
      }),
      { numRuns: 300 },
    );
  });
});

describe('the reference', () => {
  it('falls by the closed form', () => {
    const [x, y] = referenceEnd(FALL.level, FALL.holds, FALL.seconds, 960);
    expect(Math.abs(x + fallDistance(FALL.seconds))).toBeLessThan(1e-10);
    expect(y).toBe(0);
  });

  it('is settled for a minute of many target changes', () => {
    const { level, holds, seconds } = TWELVE_CIRCLES;
    const fine = referenceEnd(level, holds, seconds, 1920);
    const coarse = referenceEnd(level, holds, seconds, 960);
    expect(Math.hypot(fine[0] - coarse[0], fine[1] - coarse[1])).toBeLessThan(1e-6);
  });
});

describe('the scenes', () => {
  it.each([TWELVE_CIRCLES, ORBIT])('$name lasts its time under arcade', ({ level, holds, seconds }) => {
    const [tick, outcome] = playArcade(level, holds, seconds * 60);
    expect([tick, outcome]).toEqual([seconds * 60, 0]);
    expect(level.asteroids.length + level.novae.length).toBe(12);
  });

  it('a larger field of asteroids has the smaller one in its middle', () => {
    const small = asteroidField(100).level.asteroids;
    expect(asteroidField(2500).level.asteroids.slice(0, 100)).toEqual(small);
    const [few, many] = [asteroidField(100), asteroidField(2500)];
    expect(playArcade(many.level, many.holds, 1800)).toEqual(playArcade(few.level, few.holds, 1800));
  });
});
