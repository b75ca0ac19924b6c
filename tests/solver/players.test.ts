import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, joinHolds } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { createPlayers, type PlayerParameters, playAsPlayers, UNCALIBRATED, verifyRun } from '../../solver/index.ts';
import { practise } from '../../solver/measure/player/player.ts';
import { createTrials, judgeAll, shiftHolds, tickNoise } from '../../solver/measure/robustness/index.ts';
import { itQuick } from '../depth.ts';
import { plainLevel } from '../engine/plain-level.ts';
import { shippedLevel } from './shipped-level.ts';

const ANY = { minerals: 'any' } as const;
const TICK_MS = 1000 / 60;

const STEADY: PlayerParameters = {
  ...UNCALIBRATED,
  motorMs: 0,
  weber: 0,
  planMs: 0,
  learning: 0,
  spread: 0,
};

const forecastOf = (slug: string, parameters: Partial<PlayerParameters>, ticks: number, seed = 1) => {
  const level = shippedLevel(slug);
  const players = createPlayers(compile(level), level.runs[0].holds, ANY, {
    parameters: { ...UNCALIBRATED, ...parameters },
    seed,
  });
  players.advance(ticks);
  return players.forecast();
};

/** The errors of an edge over all players, at an attempt, ms. */
function errorsOf(holds: readonly Hold[], played: ReturnType<typeof playAsPlayers>, attempt: number, edge: number): number[] {
  const tick = joinHolds(holds).flat()[edge];
  return played.flatMap((attempts) => {
    const edges = attempts[attempt].holds.flat();
    return edges.length === holds.flat().length ? [(edges[edge] - tick) * TICK_MS] : [];
  });
}

const deviation = (values: readonly number[]): number => {
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  return Math.sqrt(values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / (values.length - 1));
};

describe('synthetic players', () => {
  it('always pass without noise, whatever the run', () => {
    for (const slug of ['03-let-go', '16-firewalk']) {
      const { attempts, half, most } = forecastOf(slug, STEADY, 30_000);
      expect(attempts.map(({ pass, solved }) => [pass.p, solved.p])).toEqual(attempts.map(() => [1, 1]));
      expect([half, most]).toEqual([1, 1]);
    }
  });

  itQuick('pass as often as all pairs of errors together, each with its probability', () => {
    // motor noise alone, two edges far apart: every pair of shifts is simulated, none is drawn
    const level = shippedLevel('22-vault');
    const scene = compile(level);
    const holds: Hold[] = [[36, 130]];
    const run = verifyRun(scene, [[2, 110]], ANY);
    const aim = run === null ? holds : [...run.holds];
    const motorMs = 60;
    const { probability, reach } = tickNoise(motorMs);
    const pairs = Array.from({ length: (2 * reach + 1) ** 2 }, (_, i) => [i % (2 * reach + 1), Math.floor(i / (2 * reach + 1))]);
    const wins = judgeAll(
      createTrials(scene, ANY),
      pairs.map(([a, b]) => shiftHolds(aim, [a - reach, b - reach])),
    );
    const exact = pairs.reduce((sum, [a, b], i) => sum + wins[i] * probability[a] * probability[b], 0);
    expect(exact).toBeGreaterThan(0.3);
    expect(exact).toBeLessThan(0.97);
    const players = createPlayers(scene, aim, ANY, { parameters: { ...STEADY, motorMs }, attempts: 1, seed: 3 });
    players.advance(1_500_000);
    const { players: count, attempts } = players.forecast();
    expect(count).toBeGreaterThan(1500);
    const error = Math.sqrt((exact * (1 - exact)) / count);
    expect(Math.abs(attempts[0].pass.p - exact)).toBeLessThan(4 * error);
  });

  it('give the same however the work is split, and another result for another seed', () => {
    const level = shippedLevel('03-let-go');
    const scene = compile(level);
    const total = 60_000;
    const forecastIn = (parts: readonly number[], seed: number) => {
      const players = createPlayers(scene, level.runs[0].holds, ANY, { seed });
      let left = total;
      for (const part of parts) {
        players.advance(Math.min(part, left));
        left -= Math.min(part, left);
      }
      players.advance(left);
      return players.forecast();
    };
    fc.assert(
      fc.property(fc.array(fc.integer({ min: 0, max: 30_000 }), { maxLength: 6 }), fc.integer(), (parts, seed) => {
        expect(forecastIn(parts, seed)).toEqual(forecastIn([], seed));
      }),
      { numRuns: 15 },
    );
    expect(forecastIn([], 1)).not.toEqual(forecastIn([], 2));
  });

  it('never pass more often with more noise of any kind, but for chance', () => {
    const more: readonly ((by: number) => Partial<PlayerParameters>)[] = [
      (by) => ({ scale: by }),
      (by) => ({ motorMs: 40 * by }),
      (by) => ({ weber: 0.07 * by }),
      (by) => ({ planMs: 120 * by }),
      (by) => ({ learning: 0.4 / by }),
    ];
    for (const slug of ['03-let-go', '04-slingshot']) {
      for (const change of more) {
        const rates = [0.5, 1, 2, 4].map((by) => forecastOf(slug, change(by), 80_000));
        for (const number of [1, 10]) {
          for (let i = 1; i < rates.length; i++) {
            const [a, b] = [rates[i - 1], rates[i]].map(({ attempts, players }) => ({
              p: attempts[number - 1].pass.p,
              n: players,
            }));
            const error = Math.sqrt((a.p * (1 - a.p)) / a.n + (b.p * (1 - b.p)) / b.n);
            expect(b.p).toBeLessThanOrEqual(a.p + 4 * error + 0.02);
          }
        }
      }
    }
  });

  it('solve a level sooner or later: the share that has solved it never falls, and is at least that of the attempt', () => {
    const { attempts } = forecastOf('04-slingshot', { scale: 2 }, 300_000);
    for (const [i, { pass, solved, range }] of attempts.entries()) {
      expect(solved.p).toBeGreaterThanOrEqual(Math.max(pass.p, attempts[i - 1]?.solved.p ?? 0));
      expect(range[0]).toBeLessThan(range[1]);
      expect([pass.low <= pass.p, pass.p <= pass.high]).toEqual([true, true]);
    }
    expect(attempts[9].pass.p).toBeGreaterThan(attempts[0].pass.p);
  });

  it('are over at once where the level is, and refuse a run that misses the goal', () => {
    const inside = plainLevel({ blackHole: { x: 0, y: 0 } });
    const players = createPlayers(compile(inside), [], ANY);
    players.advance(100);
    expect(players.forecast().attempts[0].pass.p).toBe(1);
    expect(() => createPlayers(compile(plainLevel()), [], ANY)).toThrow('misses the goal');
    expect(createPlayers(compile(inside), [], ANY).forecast()).toMatchObject({ players: 0, half: null });
  });
});

describe('the errors of a player', () => {
  const level = shippedLevel('02-first-swing');
  const scene = compile(level);
  const holds = level.runs[0].holds;
  const play = (parameters: Partial<PlayerParameters>, attempts = 1) =>
    playAsPlayers(scene, holds, ANY, 3000, { parameters: { ...STEADY, ...parameters }, attempts, seed: 8 });

  itQuick('grow with the interval that is timed, up to how far ahead she is seen', () => {
    // 150 ticks before the press, 285 before the release
    const seen = (weber: number, lookaheadMs: number, edge: number) =>
      deviation(errorsOf(holds, play({ weber, lookaheadMs }), 0, edge));
    expect(seen(0.02, 60_000, 0) / (0.02 * 150 * TICK_MS)).toBeCloseTo(1, 1);
    expect(seen(0.02, 60_000, 1) / (0.02 * 285 * TICK_MS)).toBeCloseTo(1, 1);
    expect(seen(0.1, 1000, 1) / 100).toBeCloseTo(1, 1);
  });

  it('are handed on to the next press or release where there is no time to react', () => {
    const releases = (reactionMs: number) => deviation(errorsOf(holds, play({ motorMs: 100, reactionMs }), 0, 1));
    expect(releases(250) / 100).toBeCloseTo(1, 1);
    expect(releases(60_000) / (100 * Math.SQRT2)).toBeCloseTo(1, 1);
  });

  itQuick('shrink by the power law with practice, but for those of the finger', () => {
    const played = play({ planMs: 300, lookaheadMs: 1, learning: 0.5 }, 4);
    const first = deviation(errorsOf(holds, played, 0, 0));
    // those who have not failed before have practised three times
    const steady = played.filter((attempts) => attempts.slice(0, 3).every(({ succeeds }) => succeeds));
    expect(steady.length).toBeGreaterThan(400);
    expect(deviation(errorsOf(holds, steady, 3, 0)) / first).toBeCloseTo(0.5, 1);
    const finger = play({ motorMs: 80, learning: 0.5 }, 4);
    expect(deviation(errorsOf(holds, finger, 3, 0)) / 80).toBeCloseTo(1, 1);
  });

  it('are learned of where an attempt failed: both edges of that hold count twice', () => {
    const practice = new Int32Array(6);
    practise(practice, 4, true);
    expect([...practice]).toEqual([1, 1, 2, 2, 0, 0]);
    practise(practice, 3, true);
    expect([...practice]).toEqual([2, 2, 4, 2, 0, 0]);
    practise(practice, 6, false);
    expect([...practice]).toEqual([3, 3, 5, 3, 1, 1]);
    practise(practice, 0, true);
    expect([...practice]).toEqual([3, 3, 5, 3, 1, 1]);
  });
});
