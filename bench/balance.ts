import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { RANDOM_SET_SIZE, randomLevel } from '../tests/scenes/random-set/index.ts';
import { atMost, define, inFolder, mean, median, number, runGq, sum, writeLines } from './harness/index.ts';

const timesIn = (path: string): number[] =>
  [...readFileSync(path, 'utf8').matchAll(/^\{"n":\d+,.*?"ms":([\d.e+-]+),/gm)].map(([, ms]) => Number(ms));

/** By how many percent the slowest exceeds the mean. */
const excess = (times: readonly number[]): number => 100 * (Math.max(...times) / mean(times) - 1);

export const bench = define({
  what: '2,000 random levels searched in 8 shards, by the rule and by cost',
  options: {
    random: number(RANDOM_SET_SIZE, 'levels'),
    shards: number(8, 'shards'),
    effort: number(300_000, 'ticks of a search'),
  },
  claims: { excess: atMost(10, 'by --costs, the slowest shard exceeds the mean by, %') },
  run: ({ random, shards, effort }) =>
    inFolder('balance', (folder) => {
      /** ms that the levels of each shard have taken in one thread, by a plan that knows the costs in a folder, or none. */
      const shardTimes = (costs: string | null, out: string): number[] => {
        const known = costs === null ? [] : ['--costs', costs];
        const search = ['--solve', '--effort', `${effort}`, '--brief'];
        runGq(folder, 'plan', 'set.ndjson', '--shards', `${shards}`, ...search, '--force', ...known);
        for (let i = 0; i < shards; i++) {
          runGq(folder, 'check', '--plan', 'plan.json', '--shard', `${i}`, '--out', out, '--jobs', '1');
        }
        return readdirSync(join(folder, out)).map((name) => sum(timesIn(join(folder, out, name))));
      };
      const levels = Array.from({ length: random }, (_, seed) => randomLevel(seed));
      writeLines(join(folder, 'set.ndjson'), levels);
      const ruled = shardTimes(null, 'ruled');
      const costs = readdirSync(join(folder, 'ruled')).flatMap((name) => timesIn(join(folder, 'ruled', name)));
      const balanced = shardTimes('ruled', 'balanced');
      const row = (name: string, times: readonly number[]): (string | number)[] => [
        name,
        mean(times) / 1000,
        Math.max(...times) / 1000,
        excess(times),
      ];
      return {
        title: `${random} random levels in ${shards} shards, searched with ${effort} ticks each`,
        columns: ['split', 'mean s', 'slowest s', 'slowest over mean, %'],
        rows: [row('by the rule', ruled), row('by --costs', balanced)],
        measured: { excess: excess(balanced) },
        notes: [
          `The times are those of the levels of each shard in one thread, without the start of the process. Levels take from ${Math.min(...costs).toFixed(1)} to ${Math.max(...costs).toFixed(0)} ms, median ${median(costs).toFixed(0)} ms.`,
        ],
      };
    }),
});
