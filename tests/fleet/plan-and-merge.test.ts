import { createHash } from 'node:crypto';
import { existsSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { SetDigest } from '../../cli/fleet/digest.ts';
import { readPlan } from '../../cli/fleet/plan.ts';
import { gq } from '../cli/gq.ts';
import { itDeep, itQuick } from '../depth.ts';
import {
  doAll,
  levelTexts,
  makeSet,
  merge,
  planSet,
  type RecordLine,
  resultLines,
  runShard,
  shardOfText,
  type TestSet,
} from './sets.ts';

interface Report {
  readonly levels: readonly { readonly file: string; readonly verdict: string; readonly ms: number }[];
  readonly summary: Readonly<Record<string, number>>;
}

let set: TestSet;
beforeAll(async () => {
  set = await makeSet(levelTexts(36));
});
afterAll(() => set.remove());

const reportOf = ({ stdout }: { readonly stdout: string }): Report => JSON.parse(stdout);
const withoutTimes = (report: Report): unknown => ({ ...report, levels: report.levels.map((level) => ({ ...level, ms: 0 })) });

describe('a set in shards', () => {
  it('gives the report of gq check, byte by byte the same for any number of shards in any order', async () => {
    const direct = await gq(['check', ...set.paths, '--format', 'json'], { cwd: set.directory });
    expect(direct.code).toBe(1);
    let first: string | null = null;
    await fc.assert(
      fc.asyncProperty(fc.integer({ min: 1, max: 12 }), fc.integer(), async (shards, seed) => {
        rmSync(join(set.directory, 'out'), { recursive: true, force: true });
        const order = [...Array(shards).keys()].sort(
          (a, b) => shardOfText(`${seed} ${a}`, 1e9) - shardOfText(`${seed} ${b}`, 1e9),
        );
        const merged = await doAll(set, shards, order, '--replay', '50');
        expect(merged.stderr).toMatch(/^\d+ shards?, 36 levels: each exactly once; \d+ good results? repeated: as recorded\n$/);
        expect(merged.code).toBe(direct.code);
        first ??= merged.stdout;
        expect(merged.stdout).toBe(first);
      }),
      { numRuns: 5 },
    );
    expect(withoutTimes(JSON.parse(first!))).toEqual(withoutTimes(reportOf(direct)));
    expect(JSON.parse(first!).levels.map(({ file }: { file: string }) => file)).toEqual(set.names);
  });

  itQuick('gives each level to the shard that the hash of its bytes names', async () => {
    rmSync(join(set.directory, 'out'), { recursive: true, force: true });
    await doAll(set, 5, [0, 1, 2, 3, 4]);
    for (let shard = 0; shard < 5; shard++) {
      const records = resultLines(set, shard)
        .slice(1, -1)
        .map((line): RecordLine => JSON.parse(line));
      const expected = set.texts.flatMap((text, n) => (shardOfText(text, 5) === shard ? [n] : []));
      expect(records.map(({ n }) => n)).toEqual(expected);
      for (const { n, file, sha256 } of records) {
        expect({ file, sha256 }).toEqual({ file: set.names[n], sha256: createHash('sha256').update(set.texts[n]).digest('hex') });
      }
    }
  });

  itQuick('gives files their own report in the other formats, too', async () => {
    for (const format of ['pretty', 'junit', 'markdown', 'sarif', 'github']) {
      const merged = await merge(set, '--format', format);
      expect(merged.code, format).toBe(1);
      for (const word of ['files.tar#inside/0033', 'id-19']) expect(merged.stdout, format).toContain(word);
    }
  });

  itQuick('a large set lists the levels that fail, and counts all', async () => {
    const large = await makeSet(levelTexts(1002));
    try {
      const { stdout, code } = await gq(['check', ...large.paths.slice(1)], { cwd: large.directory });
      expect(code).toBe(1);
      // 668 levels: all are listed
      expect(stdout.split('\n').filter((line) => line.startsWith('completable'))).toHaveLength(
        Number(/668 levels: (\d+) completable/.exec(stdout)![1]),
      );
      const all = await gq(['check', ...large.paths], { cwd: large.directory });
      expect(all.stdout).not.toContain('completable  ');
      expect(all.stdout).toContain('\n1002 levels: ');
    } finally {
      large.remove();
    }
  });
});

describe('a plan', () => {
  itQuick('notices every change of the set, and names the level', async () => {
    rmSync(join(set.directory, 'out'), { recursive: true, force: true });
    await planSet(set, 3);
    const file = join(set.directory, 'levels/0003.level.json');
    const before = readFileSync(file);
    try {
      writeFileSync(file, `${before} `);
      const changed = await runShard(set, 1);
      expect(changed.code).toBe(2);
      expect(changed.stderr).toContain(
        'the set is no longer that of the plan: level 4 of 36 (levels/0003.level.json) is not as planned',
      );
      rmSync(file);
      const gone = await runShard(set, 1);
      expect(gone.stderr).toContain('level 4 of 36 (levels/0004.level.json) is not as planned');
      writeFileSync(file, before);
      writeFileSync(join(set.directory, 'levels/0099.level.json'), before);
      expect((await runShard(set, 1)).stderr).toContain('level 13 of 36 (levels/0099.level.json) is not as planned');
    } finally {
      writeFileSync(file, before);
      rmSync(join(set.directory, 'levels/0099.level.json'), { force: true });
    }
    // nothing is left of the attempts
    expect(existsSync(join(set.directory, 'out')) ? readdirSync(join(set.directory, 'out')) : []).toEqual([]);
    expect((await runShard(set, 1)).code).toBe(0);
  });

  itQuick('is refused when anything in it was changed', async () => {
    await planSet(set, 3, '-o', 'doctored.json');
    const path = join(set.directory, 'doctored.json');
    const text = readFileSync(path, 'utf8');
    const plan = JSON.parse(text) as Record<string, unknown>;
    const attempt = async (content: string): Promise<string> => {
      writeFileSync(path, content);
      const result = await gq(['check', '--plan', 'doctored.json', '--shard', '0', '--out', 'o'], { cwd: set.directory });
      expect(result.code).toBe(2);
      expect(result.stderr).toMatch(/^error: doctored\.json: /);
      return result.stderr;
    };
    for (const key of Object.keys(plan)) {
      const { [key]: _, ...less } = plan;
      await attempt(JSON.stringify(less));
      const value = plan[key];
      const other = typeof value === 'number' ? value + 1 : typeof value === 'string' ? `${value.slice(1)}${value[0]}a` : [];
      await attempt(JSON.stringify({ ...plan, [key]: other }));
    }
    expect(await attempt(text.slice(0, -40))).toMatch(/line \d+, column \d+: expected a plan, found no JSON of one: expected/);
    expect(await attempt('')).toContain('line 1, column 1: expected a plan');
    expect(await attempt(text.replace('"gq"', '"gq": "plan",\n "gq"'))).toMatch(/line 3, column 2: .* key "gq" more than once/);
    expect(await attempt('[]')).toContain('expected a plan');
    expect(await attempt(JSON.stringify({ ...plan, version: 2 }))).toContain('expected a plan of version 1, found version 2');
    expect(await attempt(JSON.stringify({ ...plan, levels: 35 }))).toContain('it has been changed since gq plan wrote it');
    // the same content in another layout is the same plan
    writeFileSync(path, JSON.stringify(plan));
    expect((await gq(['check', '--plan', 'doctored.json', '--shard', '0', '--out', 'o'], { cwd: set.directory })).code).toBe(0);
  });

  it('is refused by other code', async () => {
    await planSet(set, 3);
    const path = join(set.directory, 'plan.json');
    const plan = JSON.parse(readFileSync(path, 'utf8'));
    const own = { toolkit: plan.toolkit, engine: plan.engine, code: plan.code };
    expect(readPlan(path, own)).toEqual(plan);
    expect(() => readPlan(path, { ...own, engine: '0123456789abcdef' })).toThrow(`the plan is for engine ${plan.engine}`);
    expect(() => readPlan(path, { ...own, code: 'f'.repeat(64) })).toThrow('with code ffffffffffff');
  });

  it.each([
    [['--shards', '0'], 'a whole number from 1 to 10000'],
    [['--shards', '1000000'], 'a whole number from 1 to 10000'],
    [[], "required option '--shards <n>' not specified"],
    [['--shards', '2', '--budget', '3', '--solve'], 'by the clock, each machine would get other results'],
    [['--shards', '2', '--effort', '3'], '--effort limits the search of --solve'],
    [['--shards', '2', '--costs', 'nowhere'], '--costs nowhere: no such file or directory'],
    [['--shards', '2', '--costs', 'levels'], 'it has no times'],
  ])('%j is refused', async (options, message) => {
    const { code, stderr } = await gq(['plan', 'levels', '-o', 'other.json', ...options], { cwd: set.directory });
    expect(code).toBe(2);
    expect(stderr).toContain(message);
    expect(existsSync(join(set.directory, 'other.json'))).toBe(false);
  });

  it('does not replace another file', async () => {
    writeFileSync(join(set.directory, 'mine.json'), 'mine');
    const { code, stderr } = await gq(['plan', 'levels', '--shards', '2', '-o', 'mine.json'], { cwd: set.directory });
    expect(code).toBe(2);
    expect(stderr).toContain('another file is there, and nothing was overwritten');
    expect(readFileSync(join(set.directory, 'mine.json'), 'utf8')).toBe('mine');
  });

  it('refuses a pack whose copy is in the set, and takes one that is named twice once', async () => {
    writeFileSync(join(set.directory, 'copy.ndjson.gz'), readFileSync(join(set.directory, 'lines.ndjson.gz')));
    const options = ['--shards', '2', '-o', 'twice.json'];
    const { code, stderr } = await gq(['plan', 'lines.ndjson.gz', 'copy.ndjson.gz', ...options], { cwd: set.directory });
    expect(code).toBe(2);
    expect(stderr).toContain('copy.ndjson.gz has the same content as lines.ndjson.gz');
    const once = await gq(['plan', 'lines.ndjson.gz', './lines.ndjson.gz', ...options], { cwd: set.directory });
    expect(once.stderr).toContain('wrote twice.json: 12 levels in 2 shards');
  });

  itDeep('has empty shards if there are more than levels', async () => {
    rmSync(join(set.directory, 'out'), { recursive: true, force: true });
    const lines = { ...set, paths: ['lines.ndjson.gz'] };
    const merged = await doAll(lines, 40, [...Array(40).keys()]);
    expect(JSON.parse(merged.stdout).levels).toHaveLength(12);
    rmSync(join(set.directory, 'out'), { recursive: true, force: true });
    expect((await doAll(lines, 1, [0])).stdout).toBe(merged.stdout);
  });
});

describe('the digest of a set', () => {
  const sha = (...parts: Buffer[]): Buffer => createHash('sha256').update(Buffer.concat(parts)).digest();
  /** The hash of a block as a tree, computed from the top. */
  const tree = (leaves: readonly Buffer[], size: number): Buffer => {
    if (leaves.length === 1) return leaves[0];
    let half = 1;
    while (2 * half < Math.min(size, leaves.length)) half *= 2;
    return sha(tree(leaves.slice(0, half), half), tree(leaves.slice(half), half));
  };

  it('is that of trees over blocks, for any number of levels', () => {
    fc.assert(
      fc.property(fc.oneof(fc.integer({ min: 1, max: 40 }), fc.integer({ min: 4000, max: 20_000 })), (count) => {
        const leaves = Array.from({ length: count }, (_, i) => sha(Buffer.from(`${i}`)));
        const digest = new SetDigest();
        for (const leaf of leaves) digest.add(leaf);
        const { size, blocks } = digest.end();
        expect(blocks.length).toBeLessThanOrEqual(4097);
        expect(blocks.length).toBe(Math.ceil(count / size));
        for (const k of new Set([0, blocks.length >> 1, blocks.length - 1])) {
          expect(blocks[k]).toBe(tree(leaves.slice(k * size, (k + 1) * size), size).toString('hex', 0, 16));
        }
        const seen: string[] = [];
        const again = new SetDigest(size, (hash, index) => {
          expect(index).toBe(seen.length);
          seen.push(hash.toString('hex', 0, 16));
        });
        for (const leaf of leaves) again.add(leaf);
        again.end();
        expect(seen).toEqual(blocks);
      }),
      { numRuns: 20 },
    );
  });
});
