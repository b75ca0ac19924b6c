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
import { define, median, number, words } from './harness/index.ts';

const ROUNDS = 4;

export const bench = define({
  what: 'how much generated packs of each theme differ, and what their levels cost in ticks; many minutes',
  options: {
    levels: number(4, 'levels of a pack'),
    seed: number(1, 'the seed'),
    effort: number(300_000_000, 'ticks for a try'),
    hard: number(6, 'seeds of hard levels'),
    only: words('some themes'),
  },
  claims: {},
  run({ levels: count, seed, effort, hard: hardSeeds, only }) {
    let ticks = 0;
    const generate = (options: GeneratorOptions) => {
      const generator = createGenerator(options);
      while (generator.result === null && generator.effort.ticks < effort) generator.advance(1_000_000);
      ticks += generator.effort.ticks;
      return { level: generator.result?.level ?? null, ...generator.effort };
    };
    const started = process.cpuUsage().user;
    const themes = (['none', ...THEME_NAMES, 'mixed'] as readonly PackTheme[]).filter((one) => only?.includes(one) ?? true);
    const rows = themes.map((theme) => {
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
      return [
        theme,
        kept.length,
        varietyOf(kept)?.mean ?? Number.NaN,
        kept.length < 2 ? Number.NaN : median(nearestDistances(kept)),
        made - kept.length,
        tried - made,
        (ticks - before) / Math.max(1, kept.length) / 1e6,
      ];
    });
    const hard = (['small', 'medium'] as const).flatMap((size) =>
      Array.from({ length: hardSeeds }, (_, i) => {
        const { level, ticks: cost } = generate({ seed: i + 1, size, difficulty: 'hard' });
        return `hard ${size} ${i + 1}: ${level === null ? 'nothing' : 'a level'} in ${(cost / 1e6).toFixed(0)} million ticks`;
      }),
    );
    const seconds = (process.cpuUsage().user - started) / 1e6;
    return {
      title: `Packs of ${count} levels of size medium, grades 2 to 4, from seed ${seed}`,
      columns: ['theme', 'levels', 'mean distance', 'nearest, median', 'alike', 'nothing', 'million ticks a level'],
      rows,
      measured: {},
      notes: [
        ...hard,
        `${(ticks / seconds / 1e6).toFixed(1)} million ticks a second of processor time, as the generator counts them.`,
      ],
    };
  },
});
