import process from 'node:process';
import type { LevelFile } from '../schema/index.ts';
import {
  createGenerator,
  createPackJudge,
  type GeneratorOptions,
  nearestDistances,
  type PackTheme,
  packLevel,
  THEME_NAMES,
  varietyOf,
} from '../solver/index.ts';
import { optionValue, publish, spread } from './harness.ts';

// How much the levels of packs differ, with each theme, mixed, and without one; and what levels cost.

const count = Number(optionValue('--levels') ?? 4);
const seed = Number(optionValue('--seed') ?? 1);
const effort = Number(optionValue('--effort') ?? 300_000_000);
const hardSeeds = Number(optionValue('--hard') ?? 6);
const only = optionValue('--only')?.split(',');
const ROUNDS = 4;

let ticks = 0;

function generate(options: GeneratorOptions) {
  const generator = createGenerator(options);
  while (generator.result === null && generator.effort.ticks < effort) generator.advance(1_000_000);
  ticks += generator.effort.ticks;
  return { level: generator.result?.level ?? null, ...generator.effort };
}

const started = process.cpuUsage().user;
const rows: (string | number)[][] = [];
for (const theme of (['none', ...THEME_NAMES, 'mixed'] as readonly PackTheme[]).filter((one) => only?.includes(one) ?? true)) {
  const judge = createPackJudge();
  const kept: LevelFile[] = [];
  let [tried, made] = [0, 0];
  const before = ticks;
  for (let index = 0; index < count; index++) {
    for (let round = 0; round < ROUNDS; round++) {
      tried++;
      const { level } = generate(packLevel({ seed, count, theme, grades: [2, 4] }, index, round));
      if (level === null) continue;
      made++;
      if (!judge.accepts(level)) continue;
      kept.push(level);
      break;
    }
  }
  const nearest = kept.length < 2 ? Number.NaN : spread(nearestDistances(kept)).median;
  rows.push([
    theme,
    kept.length,
    varietyOf(kept)?.mean ?? Number.NaN,
    nearest,
    made - kept.length,
    tried - made,
    (ticks - before) / Math.max(1, kept.length) / 1e6,
  ]);
}
const hard: string[] = [];
for (const size of ['small', 'medium'] as const) {
  for (let one = 1; one <= hardSeeds; one++) {
    const { level, ticks: cost } = generate({ seed: one, size, difficulty: 'hard' });
    hard.push(`hard ${size} ${one}: ${level === null ? 'nothing' : 'a level'} in ${(cost / 1e6).toFixed(0)} million ticks`);
  }
}
const seconds = (process.cpuUsage().user - started) / 1e6;
publish({
  title: `Packs of ${count} levels of size medium, grades 2 to 4, from seed ${seed}`,
  columns: ['theme', 'levels', 'mean distance', 'nearest, median', 'alike', 'nothing', 'million ticks a level'],
  rows,
  claims: [],
  notes: [
    ...hard,
    `${(ticks / seconds / 1e6).toFixed(1)} million ticks a second of processor time, as the generator counts them.`,
  ],
});
