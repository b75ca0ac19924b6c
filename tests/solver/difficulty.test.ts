import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, simulate } from '../../engine/index.ts';
import { GRADE_WORDS, measureDifficulty, successProbability } from '../../solver/index.ts';
import { type GradeInput, gradeOf } from '../../solver/measure/difficulty/grade.ts';
import { playAtRandom } from '../../solver/measure/difficulty/luck.ts';
import { findSigmaAtHalf } from '../../solver/measure/difficulty/sigma-at-half.ts';
import { itQuick } from '../depth.ts';
import { plainLevel } from '../engine/plain-level.ts';
import { shippedLevel } from './shipped-level.ts';

const ANY = { minerals: 'any' } as const;
const QUICK = { samples: 300, games: 300, effort: 0, asteroidEffort: 0, onePressStride: 10 } as const;

describe('the grade', () => {
  const input: fc.Arbitrary<GradeInput> = fc.record({
    p40: fc.double({ min: 0, max: 1, noNaN: true }),
    sigmaAtHalf: fc.double({ min: 0, max: 500, noNaN: true }),
    presses: fc.integer({ min: 0, max: 60 }),
    seconds: fc.double({ min: 0.1, max: 60, noNaN: true }),
    randomShare: fc.double({ min: 0, max: 1, noNaN: true }),
  });

  it('lies between 1 and 10, with the word for its value', () => {
    fc.assert(
      fc.property(input, (given) => {
        const { value, word } = gradeOf(given);
        expect(value).toBeGreaterThanOrEqual(1);
        expect(value).toBeLessThanOrEqual(10);
        expect(GRADE_WORDS.filter(([from]) => from <= value).at(-1)?.[1]).toBe(word);
      }),
    );
  });

  it('never falls when one input gets harder', () => {
    const harder: readonly ((g: GradeInput, by: number) => GradeInput)[] = [
      (g, by) => ({ ...g, p40: g.p40 * (1 - by) }),
      (g, by) => ({ ...g, sigmaAtHalf: g.sigmaAtHalf * (1 - by) }),
      (g, by) => ({ ...g, presses: g.presses + Math.ceil(by * 5) }),
      (g, by) => ({ ...g, seconds: g.seconds + 10 * by }),
      (g, by) => ({ ...g, randomShare: g.randomShare * (1 - by) }),
    ];
    fc.assert(
      fc.property(input, fc.nat(harder.length - 1), fc.double({ min: 0, max: 1, noNaN: true }), (given, which, by) => {
        expect(gradeOf(harder[which](given, by)).value).toBeGreaterThanOrEqual(gradeOf(given).value);
      }),
    );
  });

  it('reaches both ends', () => {
    expect(gradeOf({ p40: 1, sigmaAtHalf: 500, presses: 1, seconds: 3, randomShare: 0.9 }).value).toBe(1);
    expect(gradeOf({ p40: 0, sigmaAtHalf: 0, presses: 40, seconds: 60, randomShare: 0 }).value).toBe(10);
  });
});

describe('random play', () => {
  it('always wins where nothing can go wrong, and never where nothing can go right', () => {
    const drifting = plainLevel({ astronaut: { vx: 100 }, blackHole: { x: 60, y: 0 } });
    const options = { samples: 100, seed: 3, maxTicks: 600 };
    expect(playAtRandom(compile(drifting), ANY, options)).toMatchObject({ share: 1, high: 1, samples: 100 });
    const away = playAtRandom(compile(plainLevel()), ANY, options);
    expect(away).toMatchObject({ share: 0, low: 0 });
    expect(away.high).toBeCloseTo(0.037, 3);
  });

  it('is the same for the same seed, and differs for another', () => {
    const scene = compile(shippedLevel('06-hot-rock'));
    const share = (seed: number) => playAtRandom(scene, ANY, { samples: 200, seed, maxTicks: 3600 }).share;
    const first = share(1);
    expect(share(1)).toBe(first);
    expect(new Set([first, ...[2, 3].map(share)]).size).toBeGreaterThan(1);
  });

  it('counts only games that meet the goal', () => {
    const scene = compile(shippedLevel('06-hot-rock'));
    const share = (minerals: 'any' | 'all') => playAtRandom(scene, { minerals }, { samples: 200, seed: 1, maxTicks: 3600 }).share;
    expect(share('all')).toBeLessThan(share('any'));
  });
});

describe('the difficulty of a run', () => {
  itQuick('has its sigma at P = 0.5 where P crosses 0.5', () => {
    const level = shippedLevel('04-slingshot');
    const scene = compile(level);
    const difficulty = measureDifficulty(scene, level.runs[0].holds, { ...QUICK, seed: 5 });
    const { ms, low, high, capped } = difficulty!.sigmaAtHalf;
    expect(capped).toBe(false);
    expect(low).toBeLessThan(ms);
    expect(high).toBeGreaterThan(ms);
    const p = (sigma: number) => successProbability(scene, level.runs[0].holds, ANY, sigma, { samples: 300, seed: 5 }).p;
    expect(p(ms - 4)).toBeGreaterThanOrEqual(0.5);
    expect(p(ms + 4)).toBeLessThan(0.5);
  });

  itQuick('finds the same sigma, within 4 ms, whatever was measured before', () => {
    const level = shippedLevel('16-firewalk');
    const scene = compile(level);
    const { holds } = level.runs[0];
    const options = { samples: 150, seed: 5 };
    const success = (sigma: number) => successProbability(scene, holds, ANY, sigma, options);
    const plain = findSigmaAtHalf(scene, holds, ANY, options);
    for (const known of [[30, 40, 60, 80], [170], [400, 20]]) {
      const found = findSigmaAtHalf(scene, holds, ANY, { ...options, known: known.map(success) });
      for (const key of ['ms', 'low', 'high'] as const) expect(Math.abs(found[key] - plain[key])).toBeLessThan(4);
    }
    const easy = shippedLevel('01-first-pull');
    expect(findSigmaAtHalf(compile(easy), easy.runs[0].holds, ANY, options)).toMatchObject({ ms: 500, capped: true });
  });

  itQuick('says when the certificate was cut short', () => {
    const level = shippedLevel('16-firewalk');
    const { robustness } = measureDifficulty(compile(level), level.runs[0].holds, { ...QUICK, samples: 40, games: 40 })!;
    expect(robustness).toMatchObject({ certifiedTicks: 2, decided: false });
  });

  itQuick('takes its numbers from the run', () => {
    const level = shippedLevel('03-let-go');
    const { holds } = level.runs[0];
    const difficulty = measureDifficulty(compile(level), holds, QUICK)!;
    expect(difficulty.run.holds).toEqual(holds);
    expect(difficulty.presses).toBe(holds.length);
    expect(difficulty.length).toBe(difficulty.run.time);
    const windows = difficulty.robustness.slack.map(({ earlier, later }) => earlier + later);
    expect(difficulty.smallestWindow).toBe(Math.min(...windows));
  });

  it('is null for a run that fails', () => {
    expect(measureDifficulty(compile(shippedLevel('03-let-go')), [], QUICK)).toBeNull();
  });

  itQuick("looks for better runs than the level has, and keeps the level's where it finds none", () => {
    // Too little effort for a search from nothing.
    const little = { ...QUICK, effort: 100 };
    const level = shippedLevel('12-detour');
    expect(measureDifficulty(compile({ ...level, runs: [] }), null, little)).toBeNull();
    const { run, mineralsExtra } = measureDifficulty(compile(level), null, little)!;
    expect(level.runs.map(({ holds }) => simulate(compile(level), holds).time)).toContain(run.time);
    expect(mineralsExtra!.run.minerals).toHaveLength(level.minerals.length);
  });

  itQuick('looks for a run when none is given, and compares it with one that collects all minerals', () => {
    const level = shippedLevel('02-first-swing');
    const difficulty = measureDifficulty(compile(level), null, { ...QUICK, effort: 400_000 })!;
    expect(difficulty.run.holds.length).toBeGreaterThan(0);
    const { mineralsExtra, run } = difficulty;
    expect(mineralsExtra!.run.minerals).toHaveLength(level.minerals.length);
    expect(mineralsExtra!.presses).toBe(mineralsExtra!.run.holds.length - run.holds.length);
    expect(mineralsExtra!.time).toBe(mineralsExtra!.run.time - run.time);
  });
});
