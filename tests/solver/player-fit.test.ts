import { beforeAll, describe, expect, it } from 'vitest';
import { observe } from '../../check/plays/index.ts';
import { compile, joinHolds } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import {
  fitPlayers,
  type ObservedAttempt,
  type PlayerFit,
  type PlayerParameters,
  playAsPlayers,
  UNCALIBRATED,
  verifyRun,
} from '../../solver/index.ts';
import { Evidence } from '../../solver/measure/player/evidence.ts';
import { practiceTable, timeRun } from '../../solver/measure/player/player.ts';
import { shippedLevel } from './shipped-level.ts';

const ANY = { minerals: 'any' } as const;
const TICK_MS = 1000 / 60;

interface Study {
  readonly edges: readonly number[];
  readonly end: number;
  readonly players: ObservedAttempt[][];
}

/** Plays of synthetic players, as their files would show them. */
function studyOf(
  level: Level,
  holds: readonly Hold[],
  size: { readonly players: number; readonly attempts: number },
  truth: Partial<PlayerParameters>,
  seed: number,
): Study {
  const scene = compile(level);
  const edges = joinHolds(holds).flat();
  const options = { parameters: { ...UNCALIBRATED, ...truth }, attempts: size.attempts, seed };
  const players = playAsPlayers(scene, holds, ANY, size.players, options).map((attempts) =>
    attempts.map(({ holds: own, end, succeeds }) =>
      observe(edges, {
        edges: own.flat().filter((edge) => edge < end),
        tick: end,
        cause: succeeds ? null : { kind: 'lost', index: null },
      }),
    ),
  );
  return { edges, end: verifyRun(scene, holds, ANY)!.tick, players };
}

const fitOf = ({ edges, end, players }: Study): PlayerFit => fitPlayers(edges, end, players)!;

describe('the likelihood of the errors of a player', () => {
  it('is that of a Gaussian in whole ticks, of what has not come yet, and of few slips', () => {
    // 100 ms of motor noise only
    const run = timeRun([100, 200], 400, { ...UNCALIBRATED, motorMs: 100, weber: 0, planMs: 0 });
    const attempts: ObservedAttempt[] = [
      { shifts: [6, -3], end: 400, failed: false },
      { shifts: [2, null], end: 206, failed: true },
    ];
    const evidence = new Evidence(run, attempts);
    expect(evidence.seen).toBe(3);
    const factors = Float64Array.of(0.5, 1, 2);
    const curve = evidence.curve(factors, practiceTable(0.4, 10));
    // the density, summed by the midpoint rule
    const mass = (from: number, to: number, sd: number): number => {
      const steps = 20_000;
      const width = (to - from) / steps;
      let sum = 0;
      for (let i = 0; i < steps; i++) {
        const x = (from + (i + 0.5) * width) / sd;
        sum += Math.exp((-x * x) / 2);
      }
      return (sum * width) / (sd * Math.sqrt(2 * Math.PI));
    };
    for (const [i, factor] of factors.entries()) {
      const sd = 100 * factor;
      const seen = [6, -3, 2].map((shift) =>
        Math.log(0.99 * mass((shift - 0.5) * TICK_MS, (shift + 0.5) * TICK_MS, sd) + 0.01 / 181),
      );
      const unseen = Math.log(0.99 * mass(5.5 * TICK_MS, 5.5 * TICK_MS + 10 * sd, sd) + 0.01);
      expect(curve[i]).toBeCloseTo(
        seen.reduce((sum, value) => sum + value, unseen),
        4,
      );
    }
  });
});

describe('the player model fitted to synthetic plays', () => {
  const level = shippedLevel('02-first-swing');
  const { holds } = level.runs[0];
  const TRUTH = { scale: 1.6, learning: 0.3, spread: 0.4 };
  const STUDIES = 40;
  let fits: PlayerFit[] = [];
  beforeAll(() => {
    fits = Array.from({ length: STUDIES }, (_, i) => fitOf(studyOf(level, holds, { players: 12, attempts: 5 }, TRUTH, 400 + i)));
  });

  it.each(['scale', 'learning', 'spread'] as const)('has intervals of %s that contain the truth as often as they say', (key) => {
    const inside = fits.filter((own) => own[key]!.low <= TRUTH[key] && TRUTH[key] <= own[key]!.high).length;
    // of 40 studies, between 31 and 40 are inside with a probability of 99 %
    expect(inside).toBeGreaterThanOrEqual(31);
    const middle = fits.reduce((sum, own) => sum + own[key]!.value, 0) / STUDIES;
    expect(Math.abs(middle - TRUTH[key])).toBeLessThan(0.15 * TRUTH[key] + 0.05);
  });

  it('has intervals that are not wide for nothing: they exclude other parameters', () => {
    const excluded = (key: 'scale' | 'learning' | 'spread', value: number) =>
      fits.filter((own) => value < own[key]!.low || value > own[key]!.high).length;
    expect(excluded('scale', 0.8)).toBeGreaterThan(30);
    expect(excluded('scale', 3.2)).toBeGreaterThan(30);
    expect(excluded('learning', 1)).toBeGreaterThan(30);
    expect(excluded('spread', 1)).toBeGreaterThan(30);
  });

  it('says how much it rests on, and gets surer with more players', () => {
    expect(fits[0]).toMatchObject({ players: 12, attempts: 60 });
    const many = fitOf(studyOf(level, holds, { players: 80, attempts: 5 }, TRUTH, 9));
    const width = ({ scale: { low, high } }: PlayerFit) => high / low;
    expect(Math.log(width(many)) / Math.log(width(fits[0]))).toBeLessThan(0.7);
    expect(many.parameters).toEqual({
      ...UNCALIBRATED,
      scale: many.scale.value,
      learning: many.learning.value,
      spread: many.spread!.value,
    });
  });

  it('does not depend on the order of the players', () => {
    const study = studyOf(level, holds, { players: 6, attempts: 4 }, TRUTH, 77);
    const turned = fitOf({ ...study, players: study.players.toReversed() });
    const own = fitOf(study);
    for (const key of ['scale', 'learning', 'spread'] as const) {
      for (const end of ['value', 'low', 'high'] as const) expect(turned[key]![end]).toBeCloseTo(own[key]![end], 9);
    }
  });

  it('is not misled where only early releases are seen, because the run ends', () => {
    // she reaches the black hole while the button is held: later releases never happen
    const held = shippedLevel('05-running-start');
    const { tick } = verifyRun(compile(held), [[20, 900]], ANY)!;
    const toTheEnd: Hold[] = [[20, tick]];
    const studies = Array.from({ length: 12 }, (_, i) => studyOf(held, toTheEnd, { players: 12, attempts: 5 }, { scale: 1 }, i));
    const shifts = studies.flatMap(({ players }) => players.flat().map(({ shifts: [, release] }) => release));
    const seen = shifts.filter((shift) => shift !== null);
    expect(seen.length).toBeLessThan(0.7 * shifts.length);
    const mean = studies.reduce((sum, study) => sum + Math.log(fitOf(study).scale.value), 0) / studies.length;
    expect(Math.exp(mean)).toBeGreaterThan(0.88);
    expect(Math.exp(mean)).toBeLessThan(1.14);
  });

  it('has no spread with one player, and nothing without presses to compare', () => {
    const alone = fitOf(studyOf(level, holds, { players: 1, attempts: 30 }, { scale: 2, spread: 0 }, 5));
    expect(alone.spread).toBeNull();
    expect(alone.scale.low).toBeLessThan(2);
    expect(alone.scale.high).toBeGreaterThan(1);
    expect(fitPlayers([100, 200], 300, [])).toBeNull();
    expect(fitPlayers([100, 200], 300, [[{ shifts: [null, null], end: 50, failed: true }]])).toBeNull();
    expect(fitPlayers([], 300, [[{ shifts: [], end: 300, failed: false }]])).toBeNull();
  });
});
