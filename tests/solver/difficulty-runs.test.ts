import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { type Difficulty, findRuns, measureDifficulty, successProbability, verifyRun } from '../../solver/index.ts';
import { itDeep, itQuick } from '../depth.ts';
import { shippedLevel } from './shipped-level.ts';

const ANY = { minerals: 'any' } as const;
const QUICK = { samples: 300, games: 300, effort: 0, asteroidEffort: 0, onePressStride: 60, playerEffort: 0 } as const;

/** A run that has hardly any slack left: the first press and the last release moved to the ends of what they may. */
function tightened(slug: string): { level: ReturnType<typeof shippedLevel>; tight: Hold[] } {
  const level = shippedLevel(slug);
  const scene = compile(level);
  const { holds } = level.runs[0];
  let tight = holds.map(([press, release]): Hold => [press, release]);
  for (let by = 1; by < 200; by++) {
    const next = holds.map(([press, release], i): Hold => (i === 0 ? [press + by, release] : [press, release]));
    if (verifyRun(scene, next, ANY) === null) break;
    tight = next;
  }
  return { level, tight };
}

describe('the run that is measured', () => {
  itQuick('is the one that forgives most, whatever the order of the runs', () => {
    const { level, tight } = tightened('07-nova-lane');
    const scene = compile(level);
    const good = level.runs[0].holds;
    const p40 = (holds: readonly Hold[]) => successProbability(scene, holds, ANY, 40, { seed: 99 }).p;
    expect(p40(tight)).toBeLessThan(p40(good) - 0.2);
    for (const runs of [
      [tight, good],
      [good, tight],
    ]) {
      const { run, comparison, robustness } = measureDifficulty(scene, null, { ...QUICK, runs })!;
      expect(run.holds).toEqual(good);
      expect(comparison.runs.map((own) => own.run.holds)).toEqual([good, tight]);
      const [a, b] = comparison.runs;
      expect(comparison.meanP40).toBeCloseTo((a.p40 + b.p40) / 2, 12);
      expect(comparison.meanGrade).toBeCloseTo((a.grade + b.grade) / 2, 12);
      expect(a.p40).toBeGreaterThan(comparison.meanP40);
      expect(Math.abs(robustness.p40.p - p40(good))).toBeLessThan(0.05);
    }
  });

  itQuick('is found by the search where the level has only one that forgives little, and grades the level easier', () => {
    const { level, tight } = tightened('07-nova-lane');
    const scene = compile({ ...level, minerals: [], runs: [{ ...level.runs[0], holds: tight }] });
    const alone = measureDifficulty(scene, tight, QUICK)!;
    const best = measureDifficulty(scene, null, { ...QUICK, effort: 5_000_000 })!;
    expect(best.robustness.p40.p).toBeGreaterThan(alone.robustness.p40.p + 0.2);
    expect(best.grade.value).toBeLessThan(alone.grade.value - 0.3);
    expect(best.comparison.runs.at(-1)!.p40).toBeLessThanOrEqual(best.comparison.meanP40);
  });

  it('never makes a level harder: a run more, or more slack, lowers the grade or leaves it', () => {
    const { level, tight } = tightened('03-let-go');
    const scene = compile(level);
    const good = level.runs[0].holds;
    const moved = good.map(([press, release]): Hold => [press + 5, release + 5]);
    const pool = [tight, good, moved, ...level.runs.slice(1).map(({ holds }) => holds)];
    const gradeOfRuns = (runs: readonly (readonly Hold[])[]) => measureDifficulty(scene, null, { ...QUICK, runs })!.grade.value;
    expect(gradeOfRuns([good])).toBeLessThan(gradeOfRuns([tight]));
    fc.assert(
      fc.property(fc.uniqueArray(fc.nat(pool.length - 1), { minLength: 2 }), (chosen) => {
        const runs = chosen.map((i) => pool[i]);
        // runs are compared with fewer attempts than the one that is measured, hence a tenth
        expect(gradeOfRuns(runs)).toBeLessThanOrEqual(gradeOfRuns(runs.slice(1)) + 0.1001);
      }),
      { numRuns: 6 },
    );
  });

  itDeep('goes with less slack into a harder grade: a black hole half as large', () => {
    for (const slug of ['03-let-go', '07-nova-lane', '22-vault']) {
      const level = shippedLevel(slug);
      const { holds } = level.runs[0];
      const gradeWith = (radius: number): number | null => {
        const smaller = { ...level, blackHole: { ...level.blackHole, radius } };
        return measureDifficulty(compile(smaller), holds, QUICK)?.grade.value ?? null;
      };
      const { radius } = level.blackHole;
      const [large, small] = [gradeWith(radius)!, gradeWith(radius / 2)];
      if (small !== null) expect(small).toBeGreaterThanOrEqual(large);
    }
  });

  itQuick('keeps a hold that goes on beyond the end, as a player would hold on', () => {
    const level = shippedLevel('22-vault');
    const scene = compile(level);
    const { tick } = verifyRun(scene, level.runs[0].holds, ANY)!;
    const cut = level.runs[0].holds.map(([press, release]): Hold => [press, Math.min(release, tick + 1)]);
    const held = cut.map(([press, release]): Hold => [press, release > tick ? release + 300 : release]);
    expect(measureDifficulty(scene, held, QUICK)!.run).toMatchObject({ holds: held, tick });
  });
});

describe('the difficulty', () => {
  const measured = (seed: number): Difficulty =>
    measureDifficulty(compile(shippedLevel('03-let-go')), null, { ...QUICK, effort: 60_000, playerEffort: 30_000, seed })!;

  itDeep('is the same for the same seed, and another for another one', () => {
    expect(measured(1)).toEqual(measured(1));
    expect(measured(2)).not.toEqual(measured(1));
  });

  itQuick('has a forecast of players who aim at the measured run, unless nothing is spent on it', () => {
    const { forecast } = measured(1);
    expect(forecast!.players).toBeGreaterThan(2);
    expect(forecast!.attempts).toHaveLength(10);
    expect(measureDifficulty(compile(shippedLevel('03-let-go')), [[100, 260]], QUICK)?.forecast ?? null).toBeNull();
  });

  it('says what was tried where no run is found', () => {
    const level = shippedLevel('15-three-swings');
    const found = findRuns(compile({ ...level, runs: [] }), ANY, { effort: 2000, seed: 0, maxTicks: 3600 });
    expect(found.runs).toEqual([]);
    // half of the effort, then the other half
    expect(found.effort.ticks).toBeGreaterThanOrEqual(2000);
    expect(found.closest!.distance).toBeGreaterThan(0);
  });
});
