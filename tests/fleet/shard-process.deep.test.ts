import { execFile } from 'node:child_process';
import { existsSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { fallThrough, gq, gqProcess, MAIN } from '../cli/gq.ts';
import { until } from '../until.ts';
import { levelTexts, makeSet, merge, planSet, runShard, type TestSet } from './sets.ts';

// processes of their own, with threads

let set: TestSet;
beforeAll(async () => {
  set = await makeSet(levelTexts(90));
  await planSet(set, 2);
});
afterAll(() => set.remove());

const shard = (out: string, index: string, jobs: number, during?: Parameters<typeof gqProcess>[1]) =>
  gqProcess(['check', '--plan', 'plan.json', '--shard', index, '--out', out, '--jobs', `${jobs}`], {
    cwd: set.directory,
    ...during,
  });
const listed = (folder: string): string[] => readdirSync(join(set.directory, folder)).sort();

describe('a shard', () => {
  it('that two processes do at once has one result', async () => {
    const both = await Promise.all([shard('out', '0', 2), shard('out', '0', 1)]);
    expect(both.map(({ code }) => code)).toEqual([0, 0]);
    expect(listed('out')).toEqual(['shard-0.ndjson']);
  });

  it('is the same in threads as in one', async () => {
    rmSync(join(set.directory, 'out'), { recursive: true });
    expect((await shard('out', '1/2', 2)).code).toBe(0);
    expect((await runShard(set, '2/2')).code).toBe(0);
    const merged = await merge(set, '--format', 'json');
    const direct = await gq(['check', ...set.paths, '--format', 'json'], { cwd: set.directory });
    const verdicts = (text: string) =>
      JSON.parse(text).levels.map(({ file, verdict }: Record<string, string>) => [file, verdict]);
    expect(verdicts(merged.stdout)).toEqual(verdicts(direct.stdout));
  });

  it.each([
    ['SIGTERM', 143],
    ['SIGINT', 130],
  ] as const)('that gets %s leaves nothing', async (signal, code) => {
    const out = `out-${signal}`;
    const ended = await shard(out, '0', 2, {
      during: (child) => {
        const unfinished = () => existsSync(join(set.directory, out)) && listed(out).length > 0;
        void until(() => unfinished() || child.exitCode !== null).then(() => child.kill(signal));
      },
    });
    // it may have ended before the signal
    if (ended.code !== 0) {
      expect(ended).toMatchObject({ code, stdout: '' });
      expect(listed(out)).toEqual([]);
    } else expect(listed(out)).toEqual(['shard-0.ndjson']);
  });

  it('that finds no room says so and leaves nothing', async () => {
    // a limit in KiB on the size of files, as of a full disk
    const { code, stderr } = await new Promise<{ code: number; stderr: string }>((resolve) => {
      const script = `ulimit -f 8; exec "$0" "$@"`;
      const check = ['check', '--plan', 'plan.json', '--shard', '0', '--out', 'full', '--jobs', '1'];
      const args = ['-c', script, process.execPath, MAIN, ...check];
      execFile('bash', args, { cwd: set.directory }, (error, _, errors) =>
        resolve({ code: Number(error?.code ?? 0), stderr: errors }),
      );
    });
    expect(code).toBe(2);
    expect(stderr).toMatch(/full\/shard-0\.ndjson: can't be written: .*; the shard has no result/);
    expect(listed('full')).toEqual([]);
  });

  it('refuses a place that is no directory', async () => {
    writeFileSync(join(set.directory, 'file'), '');
    const { code, stderr } = await shard('file', '0', 1);
    expect(code).toBe(2);
    expect(stderr).toContain("error: file: can't be written");
  });
});

describe('a thread that dies', () => {
  it('costs only the level that has killed it', async () => {
    const dying = join(set.directory, 'dying.mjs');
    // in threads, reading this level takes all memory
    writeFileSync(
      dying,
      `import { isMainThread } from 'node:worker_threads';
       const { toString } = Buffer.prototype;
       if (!isMainThread) {
         Buffer.prototype.toString = function (...args) {
           const text = toString.apply(this, args);
           for (const all = []; text.includes('Deadly level'); ) all.push(new Array(1e6).fill(0.5));
           return text;
         };
       }`,
    );
    const texts = [fallThrough({ name: 'One' }), fallThrough({ name: 'Deadly level' }), fallThrough({ name: 'Three' })];
    writeFileSync(join(set.directory, 'deadly.ndjson'), texts.join('\n'));
    const { code, stdout } = await gqProcess(['check', 'deadly.ndjson', '--format', 'json', '--jobs', '2'], {
      cwd: set.directory,
      // so that there is not much of it
      env: { ...process.env, NODE_OPTIONS: `--import=${dying} --max-old-space-size=200` },
    });
    expect(code).toBe(2);
    const levels = JSON.parse(stdout).levels as { readonly file: string; readonly verdict: string }[];
    expect(levels.map(({ file, verdict }) => [file, verdict])).toEqual([
      ['deadly.ndjson#1', 'completable'],
      ['deadly.ndjson#2', 'crashed'],
      ['deadly.ndjson#3', 'completable'],
    ]);
  });
});

it('memory does not grow with the number of levels', async () => {
  const level = `${JSON.stringify({ version: 1 })}\n`;
  const peak = async (count: number): Promise<number> => {
    writeFileSync(join(set.directory, 'many.ndjson'), level.repeat(count));
    const usage = join(set.directory, 'usage.json');
    const { code } = await gqProcess(['check', 'many.ndjson', '--reporter', 'json=many.json', '--jobs', '1'], {
      cwd: set.directory,
      env: { ...process.env, GQ_USAGE: usage, NODE_OPTIONS: `--import=${new URL('../../bench/usage.mjs', import.meta.url)}` },
    });
    expect(code).toBe(1);
    return JSON.parse(readFileSync(usage, 'utf8')).maxRSS / 1024;
  };
  const [few, many] = [await peak(1000), await peak(20_000)];
  expect(many).toBeLessThan(300);
  // 19,000 reports of more than 2 kB each would be 40 MB
  expect(many - few).toBeLessThan(60);
});
