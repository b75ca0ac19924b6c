import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { copiedLevels } from './copied-levels.ts';
import { runGq, type Usage } from './gq-process.ts';
import { atLeast, atMost, optionValue, publish, spread } from './harness.ts';
import { drawPacks } from './packs/index.ts';

const PICTURE = fileURLToPath(new URL('../../docs/packs.svg', import.meta.url));

/** Levels of the sets: their memory is compared. */
const SIZES = [1000, 20_000, 100_000];
/** Levels of the two sets by whose difference throughput is measured: in both, the code has been compiled to machine code. */
const [FEW, MANY] = [20_000, 100_000];
const ROUNDS = 3;

const folder = mkdtempSync(join(tmpdir(), 'gq-bench-packs-'));
const at = (name: string): string => join(folder, name);
const gq = (codes: readonly number[], ...args: readonly string[]): Usage => runGq(folder, codes, args);

/** The median of a figure over several processes. */
const median = (uses: readonly Usage[], of: (usage: Usage) => number): number => spread(uses.map(of)).median;

try {
  for (const size of SIZES)
    writeFileSync(
      at(`${size}.ndjson`),
      copiedLevels(size)
        .map((level) => `${JSON.stringify(level)}\n`)
        .join(''),
    );
  const largest = SIZES[SIZES.length - 1];
  // the start of a process is paid once and is no part of the cost of a level
  const checks = [1, 2].map((jobs) => {
    const rounds = Array.from({ length: ROUNDS }, () =>
      [FEW, MANY].map((size) => gq([0], 'check', `${size}.ndjson`, '--jobs', `${jobs}`)),
    );
    return { few: rounds.map(([few]) => few), many: rounds.map(([, many]) => many) };
  });
  const rate = ({ few, many }: (typeof checks)[number], of: (usage: Usage) => number): number =>
    (MANY - FEW) / (median(many, of) - median(few, of));
  const sizes = SIZES.map((size) => {
    rmSync(at('out'), { recursive: true, force: true });
    const check = gq([0], 'check', `${size}.ndjson`, '--format', 'json', '--reporter', 'json=report.json');
    const plan = gq([0], 'plan', `${size}.ndjson`, '--shards', '8', '--force');
    const shard = gq([0], 'check', '--plan', 'plan.json', '--shard', '0', '--out', 'out');
    for (let i = 1; i < 8; i++) gq([0], 'check', '--plan', 'plan.json', '--shard', `${i}`, '--out', 'out');
    const merge = gq([0], 'merge', 'out', '--plan', 'plan.json', '--format', 'json', '-o', 'merged.json', '--replay', 'none');
    return { size, check, plan, shard, merge };
  });
  const [small] = sizes;
  const big = sizes[sizes.length - 1];
  const more = (of: 'plan' | 'merge'): number => (big.size - small.size) / (big[of].seconds - small[of].seconds);
  // a shard of very many has no level of its own: what is left is reading, hashing and comparing
  gq([0], 'plan', `${largest}.ndjson`, '--shards', '10000', '--force');
  const skip = gq([0], 'check', '--plan', 'plan.json', '--shard', '0', '--out', 'none', '--jobs', '1');
  const scanned = largest / skip.seconds;
  const perCore = rate(checks[0], (usage) => usage.processor);
  const together = rate(checks[1], (usage) => usage.seconds) / rate(checks[0], (usage) => usage.seconds);
  // one worker alone may use more than a core: garbage is collected beside it
  const busy = rate(checks[1], (usage) => usage.seconds) / (2 * perCore);
  const most = Math.max(
    ...sizes.flatMap(({ check, plan, shard, merge }) => [check, plan, shard, merge].map(({ memory }) => memory)),
  );
  writeFileSync(
    PICTURE,
    drawPacks(
      sizes.map(({ size, check, plan, shard, merge }) => ({
        size,
        check: check.memory,
        plan: plan.memory,
        shard: shard.memory,
        merge: merge.memory,
      })),
      {
        perCore,
        twoWorkers: rate(checks[1], (usage) => usage.seconds),
        scanned,
        planned: more('plan'),
        merged: more('merge'),
      },
    ),
  );
  publish({
    title: `Packs of levels of ${Math.round(readFileSync(at(`${SIZES[0]}.ndjson`)).length / SIZES[0])} bytes, one run each, at precise`,
    columns: ['levels', 'check MB', 'plan MB', 'shard MB', 'merge MB', 'plan s', 'merge s'],
    rows: sizes.map(({ size, check, plan, shard, merge }) => [
      size,
      check.memory,
      plan.memory,
      shard.memory,
      merge.memory,
      plan.seconds,
      merge.seconds,
    ]),
    claims: [
      atLeast('levels a second of one core, by processor time', perCore, Number(optionValue('--least') ?? 2000)),
      atLeast('two workers against one, by wall time', together, 1.7),
      atLeast('two workers against two cores by processor time', busy, 0.85),
      atMost('most memory of any command, MB', most, 300),
    ],
    notes: [
      `Checked with one worker: ${rate(checks[0], (usage) => usage.seconds).toFixed(0)} levels a second by wall time; with two: ${rate(checks[1], (usage) => usage.seconds).toFixed(0)}. Differences of packs of ${MANY} and ${FEW} levels, medians of ${ROUNDS} processes.`,
      `A shard skips ${scanned.toFixed(0)} levels of other shards a second, the start of the process included. gq plan reads ${more('plan').toFixed(0)} levels a second, gq merge writes ${more('merge').toFixed(0)}.`,
    ],
  });
} finally {
  rmSync(folder, { recursive: true, force: true });
}
