import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gunzipSync } from 'node:zlib';
import { DEFAULT_MAX_TICKS, TICK_RATE } from '../engine/index.ts';
import { type Hold, type Level, resolveLevel } from '../schema/index.ts';
import { ACCURACY_NAMES, atMost, compare, consume, define, lowerRank, originalFiles, packLevels, text } from './harness/index.ts';
import { replayer } from './replayer.ts';

interface Case {
  readonly name: string;
  readonly level: Level;
  readonly holds: readonly Hold[];
}

/** Every run of the shipped levels, or of those in another folder. */
const packCases = (folder: string | null): Case[] =>
  packLevels(folder ?? undefined).flatMap(({ name, level }) =>
    level.runs.map((run) => ({ name: `${name} ${run.name}`, level, holds: run.holds })),
  );

/** The runs of recordings of the original game: `original-levels.json` beside `arcade/*.json.gz`. */
function recordedCases(directory: string): Case[] {
  const originals = originalFiles(join(directory, 'original-levels.json'), false);
  const levels = new Map(originals.map(({ name, file }) => [name, resolveLevel(file)]));
  const cases: Case[] = [];
  for (const name of readdirSync(join(directory, 'arcade'))) {
    const slug = name.replace('.json.gz', '');
    const level = levels.get(slug);
    if (level === undefined) throw new Error(`expected ${slug} among the imported levels`);
    const { runs } = JSON.parse(gunzipSync(readFileSync(join(directory, 'arcade', name))).toString()) as {
      runs: { name: string; holds: Hold[] }[];
    };
    for (const run of runs) cases.push({ name: `${slug} ${run.name}`, level, holds: run.holds });
  }
  return cases;
}

export const bench = define({
  what: 'every shipped run at every accuracy',
  options: {
    levels: text('a folder of levels instead of the shipped ones'),
    recordings: text('a folder of recordings of the original game'),
  },
  claims: {
    median: atMost(4, 'precise / arcade, median run'),
    most: atMost(7, 'precise / arcade, 90 % of the runs'),
    fast: atMost(1, 'precise / fast, medians of all runs'),
  },
  run({ levels, recordings }) {
    const cases = recordings === null ? packCases(levels) : recordedCases(recordings);
    const all = ACCURACY_NAMES.map((accuracy) => ({
      accuracy,
      runs: [] as { readonly name: string; readonly ratio: number; readonly cost: number }[],
    }));
    for (const { name, level, holds } of cases) {
      const players = ACCURACY_NAMES.map((accuracy) =>
        replayer({ level, holds, seconds: DEFAULT_MAX_TICKS / TICK_RATE }, accuracy),
      );
      const measured = compare(
        players.map(({ run }, i) => ({ name: ACCURACY_NAMES[i], run })),
        { rounds: 15, sampleMs: 0.5, warmUpMs: 5 },
      );
      // accuracies may end a run at different times, so costs are compared per simulated second
      const ticks = players.map(({ simulation }) => Math.max(1, simulation.tick));
      for (const [i, { accuracy, runs }] of all.entries()) {
        const cost = (measured.time(accuracy).median * 1000) / (ticks[i] / TICK_RATE);
        runs.push({ name, ratio: measured.ratio(accuracy, ACCURACY_NAMES[0]).median / (ticks[i] / ticks[0]), cost });
      }
      consume(ticks[0]);
    }
    const at = (values: readonly number[], share: number) => lowerRank(values, share) ?? Number.NaN;
    const of = (name: string) => all.find(({ accuracy }) => accuracy === name)!.runs;
    const ratios = of('precise').map(({ ratio }) => ratio);
    const cost = (name: string) =>
      at(
        of(name).map((run) => run.cost),
        0.5,
      );
    return {
      title: `Cost of each accuracy on ${cases.length} runs`,
      columns: ['accuracy', 'us a simulated second', 'over arcade: median', '90 %', 'worst', 'worst run'],
      rows: all.map(({ accuracy, runs }) => {
        const own = runs.map(({ ratio }) => ratio);
        const worst = runs.reduce((a, b) => (b.ratio > a.ratio ? b : a));
        return [accuracy, cost(accuracy), at(own, 0.5), at(own, 0.9), worst.ratio, worst.name];
      }),
      measured: { median: at(ratios, 0.5), most: at(ratios, 0.9), fast: cost('precise') / cost('fast') },
      notes: ['Per simulated second; each run timed side by side at every accuracy, medians of 15 interleaved rounds.'],
    };
  },
});
