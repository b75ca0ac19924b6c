import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, describe, expect, it } from 'vitest';
import { gqProcess, makeFiles } from '../cli/gq.ts';
import { declareMissing } from '../missing.ts';
import { until } from '../until.ts';
import { type Cluster, missingPrograms, startCluster } from './cluster.ts';

const LEVELS = 4000;
const SHARDS = 8;

const SHIPPED = fileURLToPath(new URL('../../levels/', import.meta.url));

/** A pack of so many levels, each another; one in a hundred is broken or not valid. */
function packOf(count: number): string {
  const shipped = readdirSync(SHIPPED)
    .filter((name) => name.endsWith('.level.json'))
    .map((name) => JSON.parse(readFileSync(join(SHIPPED, name), 'utf8')))
    .map(({ runs, ...level }) => ({ ...level, runs: runs.slice(0, 1) }))
    // the short ones
    .filter(({ runs }) => runs[0].holds.length <= 1);
  return Array.from({ length: count }, (_, i) => {
    const level = { ...shipped[i % shipped.length], name: `Level ${i}` };
    if (i % 200 === 50) return JSON.stringify({ ...level, runs: [{ name: 'never', holds: [] }] });
    return JSON.stringify(i % 200 === 150 ? { ...level, colour: 'red' } : level);
  })
    .map((text) => `${text}\n`)
    .join('');
}

const missing = missingPrograms();
if (missing.length > 0) {
  declareMissing(
    'gq on Slurm',
    `Slurm is needed; missing: ${missing.join(', ')} (apt-get install slurmctld slurmd slurm-client munge)`,
  );
} else {
  describe('gq on Slurm', () => {
    const work = makeFiles({ 'set.ndjson': packOf(LEVELS) });
    let cluster: Cluster | null = null;
    // a test that takes too long goes on; its services would stay
    afterAll(async () => {
      await cluster?.stop();
      work.remove();
    });

    it('does a set in shards, loses a task and a node, does again what is missing, and merges the bytes of one process', async () => {
      cluster = await startCluster();
      await run(work.directory, cluster);
    });
  });
}

async function run(directory: string, cluster: Cluster): Promise<void> {
  const gq = async (...args: readonly string[]) => gqProcess(args, { cwd: directory, env: { ...process.env, ...cluster.env } });
  const numbers = (stdout: string): string[] => [...stdout.matchAll(/^job (\d+): /gm)].map(([, number]) => number);
  const has = (path: string): boolean => existsSync(join(directory, path));

  const planned = await gq('plan', 'set.ndjson', '--shards', `${SHARDS}`);
  expect(planned).toMatchObject({ code: 0 });
  const submitted = await gq('submit', 'slurm', '--plan', 'plan.json', '--out', 'out');
  expect(submitted).toMatchObject({ code: 0, stderr: '' });
  const [array, merging] = numbers(submitted.stdout);
  const shardOf = (task: string): number => Number(task.split('_')[1]);
  const seen = new Set<string>();
  // a task is killed while it works, so its result is not there; one that was faster is no loss
  const lost = new Set<number>();
  await until(() => {
    const tasks = cluster.running(array);
    for (const { node } of tasks) seen.add(node);
    const victim = tasks.find(({ node, task }) => node === 'n1' && has(`out/logs/shard-${shardOf(task)}.log`));
    if (victim === undefined || seen.size < 2) return false;
    cluster.killTask(victim.task);
    if (has(`out/shard-${shardOf(victim.task)}.ndjson`)) return false;
    lost.add(shardOf(victim.task));
    return true;
  });
  let requeued = 0;
  await until(() => {
    const tasks = cluster.running(array).filter(({ node }) => node === 'n2');
    if (tasks.length === 0) return false;
    requeued = tasks.filter(({ task }) => !has(`out/shard-${shardOf(task)}.ndjson`)).length;
    cluster.killNode('n2');
    return true;
  });
  expect(requeued).toBeGreaterThan(0);
  await cluster.ended(array, merging);

  // the merge has run all the same, and says what is missing
  expect(has('out/report.json')).toBe(false);
  const log = readFileSync(join(directory, 'out/logs/merge.log'), 'utf8');
  expect(log).toContain(`error: ${lost.size} of ${SHARDS} result`);
  const named = await gq('merge', 'out', '--plan', 'plan.json', '--missing', 'slurm');
  expect(named).toMatchObject({ code: 2, stdout: `${[...lost].join(',')}\n` });

  const again = await gq('submit', 'slurm', '--plan', 'plan.json', '--out', 'out', '--missing');
  expect(again.stdout).toContain(`${lost.size} of ${SHARDS} shards: ${[...lost].join(',')}\n`);
  await cluster.ended(...numbers(again.stdout));
  expect(has('out/report.json')).toBe(true);
  expect((await gq('submit', 'slurm', '--plan', 'plan.json', '--out', 'out', '--missing')).stdout).toContain(
    'nothing is missing',
  );

  // one process, one shard
  await gq('plan', 'set.ndjson', '--shards', '1', '-o', 'one.json');
  expect(await gq('check', '--plan', 'one.json', '--shard', '0', '--out', 'one')).toMatchObject({ code: 0 });
  expect(await gq('merge', 'one', '--plan', 'one.json', '--format', 'json', '-o', 'one/report.json')).toMatchObject({ code: 1 });
  const report = readFileSync(join(directory, 'out/report.json'));
  expect(report.equals(readFileSync(join(directory, 'one/report.json')))).toBe(true);
  const { summary } = JSON.parse(report.toString());
  expect(summary).toMatchObject({ broken: LEVELS / 200, invalid: LEVELS / 200, completable: LEVELS - LEVELS / 100 });
}
