import { execFileSync } from 'node:child_process';
import { lstatSync, mkdirSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { afterAll, beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { gq, MAIN } from '../cli/gq.ts';
import { doAll, levelTexts, makeSet, merge, resultLines, runShard, type TestSet, writeResult } from './sets.ts';

// something else stands where a result, a report or a plan is to be written

let set: TestSet;
let good: Buffer;
beforeAll(async () => {
  set = await makeSet(levelTexts(12));
  await doAll(set, 1, [0]);
  good = readFileSync(path());
});
afterAll(() => set.remove());
beforeEach(() => {
  rmSync(join(set.directory, 'out'), { recursive: true });
  mkdirSync(join(set.directory, 'out'));
});

const path = (name = 'shard-0.ndjson'): string => join(set.directory, 'out', name);

describe('a file where a result belongs', () => {
  it('is replaced only if it can be the begin of that result', async () => {
    const header = good.subarray(0, good.indexOf('\n'));
    for (const length of [0, 1, header.length - 1, header.length]) {
      writeFileSync(path(), header.subarray(0, length));
      const { code, stderr } = await runShard(set, 0);
      expect(code, stderr).toBe(0);
      expect(stderr).toContain('out/shard-0.ndjson: written');
    }
    for (const text of ['notes', `${header}`.replace('"shard":0', '"shard":1'), '\0'.repeat(50)]) {
      writeFileSync(path(), text);
      const { code, stderr } = await runShard(set, 0);
      expect(code).toBe(2);
      expect(stderr).toContain('nothing was overwritten');
      expect(readFileSync(path(), 'utf8')).toBe(text);
      expect((await merge(set)).stderr).toContain('out/shard-0.ndjson: it does not begin as a result of a shard');
    }
    expect(readdirSync(join(set.directory, 'out'))).toEqual(['shard-0.ndjson']);
  });

  it('is no result if it has other levels, whatever its checksum', async () => {
    writeFileSync(path(), good);
    const lines = resultLines(set, 0).slice(0, -1);
    writeResult(set, 0, [...lines.slice(0, 3), ...lines.slice(4)]);
    const before = readFileSync(path());
    const { code, stderr } = await runShard(set, 0);
    expect(code).toBe(2);
    expect(stderr).toContain('has other levels than shard 0 of the plan');
    expect(readFileSync(path())).toEqual(before);
  });

  it('that is a broken link is no result that differs', async () => {
    symlinkSync('nowhere', path());
    const { code, stderr } = await runShard(set, 0);
    expect(code).toBe(2);
    expect(stderr).toContain('out/shard-0.ndjson: it is a broken link');
    expect(readdirSync(join(set.directory, 'out'))).toEqual(['shard-0.ndjson']);
  });

  // opening one waits for its writer
  it.skipIf(process.platform === 'win32')('that is a pipe is not waited for', async () => {
    execFileSync('mkfifo', [path()]);
    for (const { code, stderr } of [await runShard(set, 0), await merge(set)]) {
      expect(code).toBe(2);
      expect(stderr).toContain('it is a named pipe, not a regular file');
    }
    expect(lstatSync(path()).isFIFO()).toBe(true);
    const costs = await gq(['plan', ...set.paths, '--shards', '2', '--costs', 'out', '-o', 'other.json'], { cwd: set.directory });
    expect(costs.code).toBe(2);
    expect(costs.stderr).toContain("error: --costs out/shard-0.ndjson: can't be read: it is a named pipe, not a regular file");
  });
});

describe('what is read', () => {
  const inSet = (...args: readonly string[]) => gq(args, { cwd: set.directory });
  const content = (name: string): Buffer => readFileSync(join(set.directory, name));

  it('is replaced by no report of a merge', async () => {
    writeFileSync(path(), good);
    const [level] = set.names;
    for (const [file, what] of [
      ['lines.ndjson.gz', 'a level that is checked'],
      [level, 'a level that is checked'],
      ['out/shard-0.ndjson', 'a result'],
      ['plan.json', 'the plan'],
    ]) {
      const before = content(file);
      for (const to of [
        ['--format', 'json', '-o', file],
        ['--reporter', `json=${file}`],
      ]) {
        const { code, stderr } = await inSet('merge', 'out', '--plan', 'plan.json', ...to);
        expect(code).toBe(2);
        expect(stderr).toContain(`the report would replace ${what}`);
        expect(content(file)).toEqual(before);
      }
    }
    expect((await inSet('merge', 'out', '--plan', 'plan.json', '-o', 'report.txt')).code).toBe(1);
  });

  it('is replaced by no report of one of its levels', async () => {
    const before = content('lines.ndjson.gz');
    const { code, stderr } = await inSet('check', 'lines.ndjson.gz#1', '--reporter', 'json=lines.ndjson.gz');
    expect(code).toBe(2);
    expect(stderr).toContain('the report would replace a level that is checked');
    expect(content('lines.ndjson.gz')).toEqual(before);
  });

  it('is replaced by no plan, which --force replaces only by another', async () => {
    const before = content('lines.ndjson.gz');
    const plan = (...options: readonly string[]) => inSet('plan', 'lines.ndjson.gz', '--shards', '2', ...options);
    for (const options of [[], ['--force']]) {
      const { code, stderr } = await plan('-o', 'lines.ndjson.gz', ...options);
      expect(code).toBe(2);
      expect(stderr).toContain('another file is there, and nothing was overwritten');
      expect(content('lines.ndjson.gz')).toEqual(before);
    }
    expect((await plan('-o', 'small.json')).code).toBe(0);
    expect((await plan('-o', 'small.json', '--brief')).stderr).toContain('replace it with --force');
    expect((await plan('-o', 'small.json', '--brief', '--force')).code).toBe(0);
    expect((await plan('-o', 'small.json', '--brief')).code).toBe(0);
  });

  // opening a pipe to compare what is in it would wait for ever
  it.skipIf(process.platform === 'win32')('is not what a plan is written to, if that is a pipe', async () => {
    const piped = execFileSync(
      'sh',
      ['-c', '"$0" "$@" | cat', process.execPath, MAIN, 'plan', 'levels', '--shards', '2', '-o', '/dev/stdout'],
      {
        cwd: set.directory,
        timeout: 60_000,
        stdio: ['ignore', 'pipe', 'ignore'],
      },
    );
    expect(JSON.parse(String(piped))).toMatchObject({ gq: 'plan', levels: 4 });
  });
});
