import { rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { levelChecker, settingsFor } from '../cli/check/index.ts';
import { noConfiguration } from '../cli/config/index.ts';
import { compile, simulate } from '../engine/index.ts';
import { resolveLevel } from '../schema/index.ts';
import { drawPacks } from './draw-packs.ts';
import {
  atLeast,
  atMost,
  compare,
  copiedLevels,
  define,
  type Ended,
  inFolder,
  median,
  PROJECT,
  runGq,
  sum,
  text,
  writeLines,
} from './harness/index.ts';

/** Levels of the sets: their memory is compared. */
const SIZES = [1000, 20_000, 100_000];
/** Levels of the two sets by whose difference throughput is measured: in both, the code has been compiled to machine code. */
const [FEW, MANY] = [20_000, 100_000];
const ROUNDS = 3;
/** Levels that are checked, and whose runs are simulated, in turns within one process. */
const SIDE_BY_SIDE = 66;

/** How many times as long the check of a pack takes as compiling its levels and simulating their runs. */
async function checkOverSimulation(folder?: string): Promise<number> {
  const check = await levelChecker();
  const files = copiedLevels(SIDE_BY_SIDE, folder);
  const levels = files.map((file) => resolveLevel(file));
  const given = files.map((file, i) => ({ file: `${i}`, content: Buffer.from(JSON.stringify(file)) }));
  const settings = { ...settingsFor({ seed: 0 }, noConfiguration(), SIDE_BY_SIDE), inFull: false };
  const { ratio } = compare(
    [
      { name: 'simulate', run: () => sum(levels.map((level) => simulate(compile(level), level.runs[0].holds).tick)) },
      { name: 'check', run: () => sum(check(given, settings, null).map(({ level }) => level.run?.tick ?? 0)) },
    ],
    { sampleMs: 200, warmUpMs: 3000 },
  );
  return ratio('check', 'simulate').median;
}

export const bench = define({
  what: 'packs of up to 100,000 levels: levels a second, memory, plan and merge; draws docs/packs.svg',
  options: { levels: text('a folder of levels to copy instead of the shipped ones') },
  claims: {
    check: atMost(2.6, 'the check of levels over the simulation of their runs, by time'),
    perCore: atLeast(2000, 'levels a second of one core, by processor time'),
    together: atLeast(1.4, 'two workers against one, by wall time'),
    busy: atLeast(0.75, 'two workers against two cores by processor time'),
    memory: atMost(300, 'most memory of any command, MB'),
  },
  run: ({ levels }) =>
    inFolder('packs', async (folder) => {
      const gq = (...args: readonly string[]) => runGq(folder, ...args);
      /** The median of a figure over several processes. */
      const middle = (uses: readonly Ended[], of: (usage: Ended) => number): number => median(uses.map(of));
      for (const size of SIZES) writeLines(join(folder, `${size}.ndjson`), copiedLevels(size, levels ?? undefined));
      const largest = SIZES[SIZES.length - 1];
      // the start of a process is paid once and is no part of the cost of a level
      const checks = [1, 2].map((jobs) => {
        const rounds = Array.from({ length: ROUNDS }, () =>
          [FEW, MANY].map((size) => gq('check', `${size}.ndjson`, '--jobs', `${jobs}`)),
        );
        const [few, many] = [0, 1].map((i) => rounds.map((round) => round[i]));
        return (of: (usage: Ended) => number): number => (MANY - FEW) / (middle(many, of) - middle(few, of));
      });
      const sizes = SIZES.map((size) => {
        rmSync(join(folder, 'out'), { recursive: true, force: true });
        const check = gq('check', `${size}.ndjson`, '--format', 'json', '--reporter', 'json=report.json');
        const plan = gq('plan', `${size}.ndjson`, '--shards', '8', '--force');
        const [shard] = Array.from({ length: 8 }, (_, i) =>
          gq('check', '--plan', 'plan.json', '--shard', `${i}`, '--out', 'out'),
        );
        const merge = gq('merge', 'out', '--plan', 'plan.json', '--format', 'json', '-o', 'merged.json', '--replay', 'none');
        return { size, used: { check, plan, shard, merge } };
      });
      const [small] = sizes;
      const big = sizes[sizes.length - 1];
      const more = (of: 'plan' | 'merge'): number => (big.size - small.size) / (big.used[of].seconds - small.used[of].seconds);
      // a shard of very many has no level of its own: what is left is reading, hashing and comparing
      gq('plan', `${largest}.ndjson`, '--shards', '10000', '--force');
      const scanned = largest / gq('check', '--plan', 'plan.json', '--shard', '0', '--out', 'none', '--jobs', '1').seconds;
      const [one, two] = checks;
      const perCore = one(({ processor }) => processor);
      const [alone, twoWorkers] = [one, two].map((rate) => rate(({ seconds }) => seconds));
      const memory = sizes.map(({ size, used: { check, plan, shard, merge } }) => ({
        size,
        check: check.memory,
        plan: plan.memory,
        shard: shard.memory,
        merge: merge.memory,
      }));
      const rates = { perCore, twoWorkers, scanned, planned: more('plan'), merged: more('merge') };
      writeFileSync(join(PROJECT, 'docs/packs.svg'), drawPacks(memory, rates));
      const bytes = Math.round(statSync(join(folder, `${SIZES[0]}.ndjson`)).size / SIZES[0]);
      return {
        title: `Packs of levels of ${bytes} bytes, one run each, at precise`,
        columns: ['levels', 'check MB', 'plan MB', 'shard MB', 'merge MB', 'plan s', 'merge s'],
        rows: sizes.map(({ used: { plan, merge } }, i) => [...Object.values(memory[i]), plan.seconds, merge.seconds]),
        measured: {
          check: await checkOverSimulation(levels ?? undefined),
          perCore,
          together: twoWorkers / alone,
          // one worker alone may use more than a core: garbage is collected beside it
          busy: twoWorkers / (2 * perCore),
          memory: Math.max(...sizes.flatMap(({ used }) => Object.values(used).map((usage) => usage.memory))),
        },
        notes: [
          `Checked with one worker: ${alone.toFixed(0)} levels a second by wall time; with two: ${twoWorkers.toFixed(0)}. Differences of packs of ${MANY} and ${FEW} levels, medians of ${ROUNDS} processes.`,
          `A shard skips ${scanned.toFixed(0)} levels of other shards a second, the start of the process included. gq plan reads ${more('plan').toFixed(0)} levels a second, gq merge writes ${more('merge').toFixed(0)}.`,
        ],
      };
    }),
});
