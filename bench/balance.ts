import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { RANDOM_SET_SIZE, randomLevel } from '../tests/scenes/random-set/index.ts';
import { atMost, optionValue, publish, spread } from './harness.ts';

const GQ = fileURLToPath(new URL('../cli/main.js', import.meta.url));

const LEVELS = Number(optionValue('--random') ?? RANDOM_SET_SIZE);
const SHARDS = Number(optionValue('--shards') ?? 8);
/** Ticks of a search. */
const EFFORT = optionValue('--effort') ?? '300000';

const folder = mkdtempSync(join(tmpdir(), 'gq-bench-balance-'));

function gq(...args: readonly string[]): string {
  const { status, stderr } = spawnSync(process.execPath, [GQ, ...args], { cwd: folder, encoding: 'utf8', maxBuffer: 2 ** 30 });
  if (status !== 0) throw new Error(`gq ${args.join(' ')}: exit code ${status}: ${stderr}`);
  return stderr;
}

/** ms that the levels of each shard have taken in one thread, by a plan that knows the costs in a folder, or none. */
function shardTimes(costs: string | null, out: string): number[] {
  const known = costs === null ? [] : ['--costs', costs];
  gq('plan', 'set.ndjson', '--shards', `${SHARDS}`, '--solve', '--effort', EFFORT, '--brief', '--force', ...known);
  for (let i = 0; i < SHARDS; i++) gq('check', '--plan', 'plan.json', '--shard', `${i}`, '--out', out, '--jobs', '1');
  return readdirSync(join(folder, out)).map((name) => timesIn(join(folder, out, name)).reduce((sum, ms) => sum + ms, 0));
}

const timesIn = (path: string): number[] =>
  [...readFileSync(path, 'utf8').matchAll(/^\{"n":\d+,.*?"ms":([\d.e+-]+),/gm)].map(([, ms]) => Number(ms));

/** By how many percent the slowest exceeds the mean. */
const excess = (times: readonly number[]): number =>
  100 * (Math.max(...times) / (times.reduce((sum, ms) => sum + ms, 0) / times.length) - 1);

try {
  const lines = Array.from({ length: LEVELS }, (_, seed) => `${JSON.stringify(randomLevel(seed))}\n`);
  writeFileSync(join(folder, 'set.ndjson'), lines.join(''));
  const ruled = shardTimes(null, 'ruled');
  const costs = readdirSync(join(folder, 'ruled')).flatMap((name) => timesIn(join(folder, 'ruled', name)));
  const balanced = shardTimes('ruled', 'balanced');
  const { median } = spread(costs);
  const row = (name: string, times: readonly number[]): (string | number)[] => {
    const total = times.reduce((sum, ms) => sum + ms, 0);
    return [name, total / times.length / 1000, Math.max(...times) / 1000, excess(times)];
  };
  publish({
    title: `${LEVELS} random levels in ${SHARDS} shards, searched with ${EFFORT} ticks each`,
    columns: ['split', 'mean s', 'slowest s', 'slowest over mean, %'],
    rows: [row('by the rule', ruled), row('by --costs', balanced)],
    claims: [atMost('by --costs, the slowest shard exceeds the mean by, %', excess(balanced), 10)],
    notes: [
      `The times are those of the levels of each shard in one thread, without the start of the process. Levels take from ${Math.min(...costs).toFixed(1)} to ${Math.max(...costs).toFixed(0)} ms, median ${median.toFixed(0)} ms.`,
    ],
  });
} finally {
  rmSync(folder, { recursive: true, force: true });
}
