import { findRuns } from '../solver/index.ts';
import { seeded } from '../tests/scenes/index.ts';
import { measureCoverage } from './difficulty/coverage.ts';
import { type Halves, measureHalves } from './difficulty/halves.ts';
import { ANY, type MeasuredScene, scenesToMeasure } from './difficulty/levels.ts';
import { measureRecovery, type Recovery } from './difficulty/recovery.ts';
import { correlation, Share, spearmanBrown } from './difficulty/statistics.ts';
import { askedLevels, atLeast, atMost, define, figure, LEVELS, number, sum } from './harness/index.ts';

// how reliable the measure of difficulty is, and whether its intervals contain the truth; with synthetic players only

const say = (text: string): void => {
  if (process.stderr.isTTY) process.stderr.write(`${text}\n`);
};

/** The correlation of both halves over the levels. */
const raw = (figureOf: (level: Halves) => readonly [number, number], among: readonly Halves[]): number =>
  correlation(
    among.map((level) => figureOf(level)[0]),
    among.map((level) => figureOf(level)[1]),
  );

const bestRun = ({ scene }: MeasuredScene) =>
  findRuns(scene, ANY, { effort: 2_000_000, seed: 0, maxTicks: 3600 }).runs.at(-1) ?? null;

export const bench = define({
  what: 'how reliable the measure of difficulty is, and whether its intervals contain what synthetic players do; 10 minutes',
  options: {
    ...LEVELS,
    random: number(30, 'levels of the random set that a plain search completes'),
    generated: number(6, 'generated levels'),
    covered: number(8, 'levels whose forecasts are compared with fresh players'),
    fitted: number(6, 'levels to whose plays the model is fitted'),
    studies: number(10, 'studies for each of these'),
  },
  claims: {
    grade: atLeast(0.95, 'grade: reliability over the levels, Spearman-Brown'),
    first: atLeast(0.95, 'pass rate at the first attempt: reliability, Spearman-Brown'),
    least: atLeast(0.85, 'share of the intervals that contains the truth'),
    most: atMost(0.95, 'the same'),
    lost: atMost(0, 'levels of which a half finds no run'),
  },
  run(asked) {
    const scenes = scenesToMeasure(askedLevels(asked), asked.random, asked.generated);
    const halves: Halves[] = [];
    const lost: string[] = [];
    for (const scene of scenes) {
      const both = measureHalves(scene);
      if (both === null) lost.push(scene.name);
      else halves.push(both);
      say(`${scene.name}: ${both?.grades.join(' ')}`);
    }
    const grades = raw(({ grades: both }) => both, halves);
    const first = raw(({ first: both }) => both, halves);

    // spread over the levels that are hard enough for their pass rates to differ from 100 %
    const uncertain = halves.filter(({ first: [a, b] }) => (a + b) / 2 < 0.98 && (a + b) / 2 > 0.02).map(({ name }) => name);
    const chosen = (count: number) =>
      scenes
        .filter(({ name }) => uncertain.includes(name))
        .filter((_, i, all) => Math.floor((i * count) / all.length) !== Math.floor(((i - 1) * count) / all.length));

    const random = seeded(2026);
    const normal = (): number => sum(Array.from({ length: 12 }, random)) - 6;
    const [pass, passInside, range] = [new Share(), new Share(), new Share()];
    for (const [i, scene] of chosen(asked.covered).entries()) {
      const holds = bestRun(scene);
      if (holds === null) continue;
      const own = measureCoverage(scene.scene, holds, 10_000 * (i + 1), normal);
      pass.addAll(own.pass);
      passInside.addAll(own.passInside);
      range.addAll(own.range);
      say(`${scene.name}: ${own.passInside.held} of ${own.passInside.tried}, ${own.range.held} of ${own.range.tried}`);
    }
    const recovery: Recovery = { scale: new Share(), learning: new Share(), spread: new Share() };
    for (const [i, scene] of chosen(asked.fitted).entries()) {
      const holds = bestRun(scene);
      if (holds !== null && holds.length > 0) {
        measureRecovery(scene.scene, holds, asked.studies, 1_000_000 + 10_000 * i, recovery);
      }
      say(`${scene.name}: ${recovery.scale.held} of ${recovery.scale.tried}`);
    }
    const recovered = Object.entries(recovery) as [string, Share][];
    const shares = Object.fromEntries([
      ['90 % intervals of pass rates', passInside.share],
      ["ranges of nine in ten players, fresh players' own rates", range.share],
      ...recovered.map(([name, { share }]) => [`90 % intervals of the fitted ${name}`, share]),
    ]);
    return {
      title: `Two halves of the measure of difficulty, ${halves.length} levels`,
      columns: ['level', 'grade', 'again', 'P(40 ms) best run', 'again', 'mean of runs', 'again', 'first attempt', 'again'],
      rows: halves.map(({ name, grades: grade, best, mean, first: pair }) => [name, ...grade, ...best, ...mean, ...pair]),
      measured: {
        grade: spearmanBrown(grades),
        first: spearmanBrown(first),
        least: shares,
        most: shares,
        lost: lost.length,
      },
      notes: [
        `Correlation of the halves, raw: grade ${figure(grades)}, first attempt ${figure(first)}, P(40 ms) of the best run ${figure(raw(({ best }) => best, halves))}, mean over the runs ${figure(raw(({ mean }) => mean, halves))}.`,
        ...(['pack', 'random', 'generated'] as const).flatMap((kind) => {
          const among = halves.filter((level) => level.kind === kind);
          if (among.length < 3) return [];
          return [
            `${kind}: ${among.length} levels, grade ${figure(raw(({ grades: both }) => both, among))}, first attempt ${figure(raw(({ first: both }) => both, among))} (raw).`,
          ];
        }),
        `Intervals of pass rates from 2 % to 98 %: ${passInside.held} of ${passInside.tried} contain the truth; of all rates ${pass.held} of ${pass.tried}. Ranges: ${range.held} of ${range.tried}.`,
        `Fits: ${recovered.map(([name, { held, tried }]) => `${name} ${held} of ${tried}`).join(', ')}.`,
        'Halves have different seeds for everything and half of the effort each. All players are synthetic: nothing here says anything about people.',
        ...(lost.length > 0 ? [`No run in one of the halves: ${lost.join(', ')}.`] : []),
      ],
    };
  },
});
