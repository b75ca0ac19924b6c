import { findRuns } from '../solver/index.ts';
import { seeded } from '../tests/scenes/index.ts';
import { measureCoverage } from './difficulty/coverage.ts';
import { type Halves, measureHalves } from './difficulty/halves.ts';
import { ANY, scenesToMeasure } from './difficulty/levels.ts';
import { measureRecovery, type Recovery } from './difficulty/recovery.ts';
import { correlation, Share, spearmanBrown } from './difficulty/statistics.ts';
import { atLeast, atMost, figure, optionValue, publish } from './harness.ts';

// how reliable the measure of difficulty is, and whether its intervals contain the truth; with synthetic players only

const RANDOM = Number(optionValue('--random') ?? 30);
const GENERATED = Number(optionValue('--generated') ?? 6);
const COVERED = Number(optionValue('--covered') ?? 8);
const FITTED = Number(optionValue('--fitted') ?? 6);
const STUDIES = Number(optionValue('--studies') ?? 10);

const scenes = scenesToMeasure(RANDOM, GENERATED);
const say = (text: string): void => {
  if (process.stderr.isTTY) process.stderr.write(`${text}\n`);
};

const halves: Halves[] = [];
const lost: string[] = [];
for (const scene of scenes) {
  const both = measureHalves(scene);
  if (both === null) lost.push(scene.name);
  else halves.push(both);
  say(`${scene.name}: ${both?.grades.join(' ')}`);
}

/** The correlation of both halves over the levels. */
const raw = (figureOf: (level: Halves) => readonly [number, number], among = halves): number =>
  correlation(
    among.map((level) => figureOf(level)[0]),
    among.map((level) => figureOf(level)[1]),
  );
const grades = raw(({ grades: both }) => both);
const first = raw(({ first: both }) => both);

// spread over the levels that are hard enough for their pass rates to differ from 100 %
const uncertain = halves.filter(({ first: [a, b] }) => (a + b) / 2 < 0.98 && (a + b) / 2 > 0.02).map(({ name }) => name);
const chosen = (count: number) =>
  scenes
    .filter(({ name }) => uncertain.includes(name))
    .filter((_, i, all) => Math.floor((i * count) / all.length) !== Math.floor(((i - 1) * count) / all.length));
const bestRun = (scene: (typeof scenes)[number]['scene']) =>
  findRuns(scene, ANY, { effort: 2_000_000, seed: 0, maxTicks: 3600 }).runs.at(-1) ?? null;

const random = seeded(2026);
const normal = (): number => Array.from({ length: 12 }, random).reduce((sum, value) => sum + value, -6);
const pass = new Share();
const passInside = new Share();
const range = new Share();
for (const [i, { name, scene }] of chosen(COVERED).entries()) {
  const holds = bestRun(scene);
  if (holds === null) continue;
  const own = measureCoverage(scene, holds, 10_000 * (i + 1), normal);
  for (const [all, part] of [
    [pass, own.pass],
    [passInside, own.passInside],
    [range, own.range],
  ] as const) {
    all.held += part.held;
    all.tried += part.tried;
  }
  say(`${name}: ${own.passInside.held} of ${own.passInside.tried}, ${own.range.held} of ${own.range.tried}`);
}

const recovery: Recovery = { scale: new Share(), learning: new Share(), spread: new Share() };
for (const [i, { name, scene }] of chosen(FITTED).entries()) {
  const holds = bestRun(scene);
  if (holds !== null && holds.length > 0) measureRecovery(scene, holds, STUDIES, 1_000_000 + 10_000 * i, recovery);
  say(`${name}: ${recovery.scale.held} of ${recovery.scale.tried}`);
}
const recovered = Object.entries(recovery) as [string, Share][];

publish({
  title: `Two halves of the measure of difficulty, ${halves.length} levels`,
  columns: ['level', 'grade', 'again', 'P(40 ms) best run', 'again', 'mean of runs', 'again', 'first attempt', 'again'],
  rows: halves.map(({ name, grades: grade, best, mean, first: pair }) => [name, ...grade, ...best, ...mean, ...pair]),
  claims: [
    atLeast('grade: reliability over the levels, Spearman-Brown', spearmanBrown(grades), 0.95),
    atLeast('pass rate at the first attempt: reliability, Spearman-Brown', spearmanBrown(first), 0.95),
    atLeast('90 % intervals of pass rates: share that contains the truth', passInside.share, 0.85),
    atMost('the same', passInside.share, 0.95),
    atLeast("ranges of nine in ten players: share of fresh players' own rates inside", range.share, 0.85),
    atMost('the same', range.share, 0.95),
    ...recovered.flatMap(([name, { share }]) => [
      atLeast(`90 % intervals of the fitted ${name}: share that contains the truth`, share, 0.85),
      atMost('the same', share, 0.95),
    ]),
    atMost('levels of which a half finds no run', lost.length, 0),
  ],
  notes: [
    `Correlation of the halves, raw: grade ${figure(grades)}, first attempt ${figure(first)}, P(40 ms) of the best run ${figure(raw(({ best }) => best))}, mean over the runs ${figure(raw(({ mean }) => mean))}.`,
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
});
