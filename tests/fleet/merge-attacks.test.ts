import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { create } from 'tar';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { fallThrough, gq } from '../cli/gq.ts';
import { itDeep, itQuick } from '../depth.ts';
import { changed, placesIn } from './mistakes.ts';
import {
  doAll,
  levelTexts,
  makeSet,
  merge,
  planSet,
  type RecordLine,
  type Result,
  resultLines,
  runShard,
  type TestSet,
  writeResult,
} from './sets.ts';

// The results of three shards are mutated and merged. A merge may then refuse, or give the true report: nothing else.

let set: TestSet;
let truth: string;
const kept = new Map<number, Buffer>();
const SHARDS = 3;

const path = (shard: number): string => join(set.directory, 'out', `shard-${shard}.ndjson`);

beforeAll(async () => {
  set = await makeSet(levelTexts(24));
  const merged = await doAll(set, SHARDS, [2, 0, 1]);
  truth = merged.stdout;
  expect(merged.code).toBe(1);
  for (let shard = 0; shard < SHARDS; shard++) kept.set(shard, readFileSync(path(shard)));
});
afterAll(() => set.remove());

/** Puts the true results back. */
function restore(): void {
  rmSync(join(set.directory, 'out'), { recursive: true });
  mkdirSync(join(set.directory, 'out'));
  for (const [shard, bytes] of kept) writeFileSync(path(shard), bytes);
}

/** Merges, and expects the truth or a refusal with one of these exit codes. */
async function attack(codes: readonly number[], ...options: readonly string[]): Promise<Result> {
  const result = await merge(set, '--format', 'json', ...options);
  expect(result.stderr).not.toContain('crashed');
  if (result.code === 1) expect(result.stdout).toBe(truth);
  else expect(result.stdout).toBe('');
  expect(codes, result.stderr).toContain(result.code);
  return result;
}

const recordsOf = (shard: number): RecordLine[] =>
  resultLines(set, shard)
    .slice(1, -1)
    .map((line) => JSON.parse(line));

/** Rewrites the records of a shard, with a correct checksum. */
function lie(shard: number, change: (records: RecordLine[]) => RecordLine[], name?: string): void {
  const [header] = resultLines(set, shard);
  writeResult(set, shard, [header, ...change(recordsOf(shard)).map((record) => JSON.stringify(record))], name);
}

describe('a merge', () => {
  it('refuses results with a byte that is another, or that are cut off', async () => {
    await fc.assert(
      fc.asyncProperty(fc.nat(SHARDS - 1), fc.nat(), fc.nat(255), fc.boolean(), async (shard, at, byte, isCut) => {
        restore();
        const bytes = Buffer.from(kept.get(shard)!);
        const place = at % bytes.length;
        if (isCut) writeFileSync(path(shard), bytes.subarray(0, place));
        else {
          if (bytes[place] === byte) return;
          bytes[place] = byte;
          writeFileSync(path(shard), bytes);
        }
        const { stderr } = await attack([2, 3]);
        expect(stderr).toContain(`shard-${shard}.ndjson`);
      }),
      { numRuns: 60 },
    );
  });

  it('refuses lines that are dropped, doubled, swapped or of another shard, whatever the checksum', async () => {
    const changes: ((records: RecordLine[]) => RecordLine[])[] = [
      (records) => records.slice(1),
      (records) => records.slice(0, -1),
      (records) => [records[0], ...records],
      (records) => [...records].reverse(),
      (records) => [...records, ...recordsOf(1)],
      () => [],
      (records) => records.map((record) => ({ ...record, n: record.n + 1 })),
      (records) => records.map((record, i) => (i === 2 ? { ...record, file: 'levels/other.level.json' } : record)),
      (records) => records.map((record, i) => (i === 2 ? { ...record, sha256: 'a'.repeat(64) } : record)),
    ];
    for (const change of changes) {
      restore();
      lie(0, change);
      const { stderr, code } = await attack([3]);
      expect(code).toBe(3);
      expect(stderr).toContain('out/shard-0.ndjson: it has other levels than shard 0 of the plan');
    }
  });

  it('refuses any change of a good result when all are repeated, and gives no report of what it cannot read', async () => {
    await fc.assert(
      fc.asyncProperty(fc.nat(SHARDS - 1), fc.nat(), fc.nat(), fc.nat(3), async (shard, which, where, how) => {
        restore();
        const records = recordsOf(shard);
        const at = which % records.length;
        const { result } = records[at];
        const places = placesIn(result);
        const place = places[where % places.length];
        const lied = changed(result, place, (holder, key) => {
          const value = holder[key];
          if (how === 0) delete holder[key];
          else if (how === 1) holder[key] = { unheardOf: value };
          else if (how === 2) holder[key] = null;
          else holder[key] = typeof value === 'number' ? value + 1 : `${value}x`;
        });
        if (JSON.stringify(lied) === JSON.stringify(result)) return;
        lie(shard, () => records.map((record, i) => (i === at ? { ...record, result: lied as typeof result } : record)));
        const { code, stdout, stderr } = await merge(set, '--format', 'json', '--replay', 'all');
        expect(stderr).not.toContain('This is a bug in gq');
        const isGood = result.verdict === 'completable';
        // a level that fails may be said to fail for another reason
        expect(isGood ? [3] : [1, 2, 3], `${place.join('.')}: ${stderr}`).toContain(code);
        if (code === 3) expect(stdout).toBe('');
        if (stdout !== '') expect(JSON.parse(stdout).summary.completable).toBe(JSON.parse(truth).summary.completable);
      }),
      { numRuns: 60 },
    );
  });

  itQuick('turns no red level green when all good results are repeated', async () => {
    for (let shard = 0; shard < SHARDS; shard++) {
      const bad = recordsOf(shard).filter(({ result }) => result.verdict !== 'completable');
      const [good] = recordsOf(shard).filter(({ result }) => result.verdict === 'completable');
      for (const { n, file } of bad) {
        restore();
        lie(shard, (records) => records.map((record) => (record.n === n ? { ...record, result: good.result } : record)));
        const { stderr } = await attack([3], '--replay', 'all');
        expect(stderr).toContain(`${file}: recorded as good, but it is `);
        // a run that a search is said to have found is played
        restore();
        const found = { ...good.result, found: [[0, 1]] };
        lie(shard, (records) => records.map((record) => (record.n === n ? { ...record, result: found } : record)));
        await attack([3], '--replay', 'all');
      }
      expect(bad.length).toBeGreaterThan(0);
    }
  });

  it('sees what is only a little better than the truth', async () => {
    const changes: ((result: Record<string, unknown>) => Record<string, unknown>)[] = [
      (result) => ({ ...result, name: 'Other' }),
      (result) => ({ ...result, run: { ...(result.run as object), time: 2 } }),
      (result) => ({ ...result, problems: [], mineralCount: 3 }),
      (result) => ({ ...result, report: null }),
    ];
    for (const change of changes) {
      restore();
      lie(1, (records) =>
        records.map((record) =>
          record.result.verdict === 'completable' ? { ...record, result: change(record.result) } : record,
        ),
      );
      await attack([3], '--replay', 'all');
    }
  });

  itDeep('a sample finds a lie as often as its share says', async () => {
    let caught = 0;
    const rounds = 24;
    for (let round = 0; round < rounds; round++) {
      restore();
      const [one] = recordsOf(0).filter(({ result }) => result.verdict !== 'completable');
      const [good] = recordsOf(0).filter(({ result }) => result.verdict === 'completable');
      // each round another lie, and so another sample
      const lied = { ...good.result, name: `Level ${round}` };
      lie(0, (records) => records.map((record) => (record.n === one.n ? { ...record, result: lied } : record)));
      const { code } = await merge(set, '--format', 'json', '--replay', '50%');
      if (code === 3) caught++;
    }
    // 12 of 24 are expected; beyond these bounds with a probability of 1e-4
    expect(caught).toBeGreaterThan(3);
    expect(caught).toBeLessThan(21);
  });

  it('names a level that two results judge differently', async () => {
    restore();
    const other = (result: Record<string, unknown>) => {
      const run = result.run as { readonly time: number };
      return { ...result, run: { ...run, time: run.time + 2 ** -50 } };
    };
    const [, second] = recordsOf(1).filter(({ result }) => result.verdict === 'completable');
    lie(
      1,
      (records) => records.map((record) => (record.n === second.n ? { ...record, result: other(record.result) } : record)),
      'shard-1.differs-1.ndjson',
    );
    const { stderr } = await attack([3]);
    expect(stderr).toContain(`out/shard-1.ndjson and out/shard-1.differs-1.ndjson differ at ${second.file}: run.time is `);
    // in another folder, too
    mkdirSync(join(set.directory, 'out/more'));
    copyFileSync(join(set.directory, 'out/shard-1.differs-1.ndjson'), join(set.directory, 'out/more/shard-1.ndjson'));
    rmSync(join(set.directory, 'out/shard-1.differs-1.ndjson'));
    expect((await merge(set)).code).toBe(1);
    expect((await gq(['merge', 'out', 'out/more', '--plan', 'plan.json'], { cwd: set.directory })).code).toBe(3);
  });

  it('takes copies that agree but for time', async () => {
    restore();
    lie(1, (records) => records.map((record) => ({ ...record, ms: record.ms + 5 })), 'shard-1.differs-1.ndjson');
    const { stderr } = await attack([1]);
    expect(stderr).toContain('out/shard-1.differs-1.ndjson: the same as out/shard-1.ndjson');
  });

  itQuick('refuses results of other plans, engines, code and versions, and overwrites none', async () => {
    const header = JSON.parse(resultLines(set, 2)[0]);
    const changes = {
      plan: ['0'.repeat(64), 'it belongs to another plan'],
      engine: ['0123456789abcdef', `expected a result of engine ${header.engine}, found one of 0123456789abcdef`],
      code: ['f'.repeat(64), 'found one of ffffffffffff'],
      version: [2, 'expected a result of version 1, found 2'],
      shard: [1, 'expected shard 2, found shard 1'],
    } as const;
    for (const [key, [value, message]] of Object.entries(changes)) {
      restore();
      const [, ...records] = resultLines(set, 2).slice(0, -1);
      writeResult(set, 2, [JSON.stringify({ ...header, [key]: value }), ...records]);
      const { stderr } = await attack([2]);
      expect(stderr).toContain(message);
      const before = readFileSync(path(2));
      const again = await runShard(set, 2);
      expect(again.code).toBe(2);
      expect(again.stderr).toContain('nothing was overwritten');
      expect(readFileSync(path(2))).toEqual(before);
    }
    restore();
    writeFileSync(path(2), 'something else\n');
    expect((await runShard(set, 2)).stderr).toContain('it does not begin as a result of a shard');
    writeFileSync(path(7), '');
    const { stderr } = await attack([2]);
    expect(stderr).toContain('out/shard-7.ndjson: the plan has shards 0 to 2 only');
  });

  itQuick('names what is missing, in each form', async () => {
    restore();
    rmSync(path(0));
    writeFileSync(path(2), kept.get(2)!.subarray(0, 500));
    const merged = await attack([2]);
    expect(merged.stderr).toContain('error: 2 of 3 results missing: shards 0,2 are not there');
    expect(merged.stderr).toContain('out/shard-2.ndjson: not counted: it is cut off');
    for (const [form, text] of [
      ['slurm', '0,2\n'],
      ['k8s', '0,2\n'],
      ['list', '0\n2\n'],
    ]) {
      expect(await merge(set, '--missing', form)).toMatchObject({ code: 2, stdout: text });
    }
    // what is missing is done again, what is damaged is replaced
    for (const shard of [0, 1, 2]) expect((await runShard(set, shard)).code).toBe(0);
    expect(await merge(set, '--missing', 'list')).toMatchObject({ code: 0, stdout: '' });
    await attack([1]);
    rmSync(join(set.directory, 'out'), { recursive: true });
    expect((await merge(set)).stderr).toContain("out: can't be read: no such file or directory");
    mkdirSync(join(set.directory, 'out'));
    expect((await merge(set)).stderr).toContain('3 of 3 results missing: shards 0-2 are not there');
    restore();
  });

  it('names a level that has changed since, when it is repeated', async () => {
    restore();
    const file = join(set.directory, 'levels/0001.level.json');
    const before = readFileSync(file);
    writeFileSync(file, `${before}\n`);
    try {
      // no alarm: nobody has computed anything else
      const { stderr } = await attack([2], '--replay', 'all');
      expect(stderr).toContain(
        'no result was repeated, as the set is no longer that of the plan: levels/0001.level.json is not as planned',
      );
      // without replays, the levels are not needed
      await attack([1], '--replay', 'none');
    } finally {
      writeFileSync(file, before);
    }
  });

  it('repeats all or nothing: a level that is gone or new is no level that was repeated', async () => {
    restore();
    const file = join(set.directory, 'files.tar');
    const before = readFileSync(file);
    const more = join(set.directory, 'levels/9999.level.json');
    try {
      // the last ones, so that those before them are as planned
      rmSync(file);
      await create({ cwd: set.directory, file }, ['inside/0016.level.json']);
      expect((await attack([2], '--replay', 'all')).stderr).toContain('it has 17 levels, 24 were planned');
      writeFileSync(file, before);
      writeFileSync(more, levelTexts(1)[0]);
      expect((await attack([2], '--replay', 'all')).stderr).toContain('the set is no longer that of the plan');
    } finally {
      rmSync(more, { force: true });
      writeFileSync(file, before);
    }
  });

  it('believes in no record that is written in another way, whatever its checksum', async () => {
    const [header, first, ...rest] = resultLines(set, 0).slice(0, -1);
    for (const [end, message] of [
      [',"file":"levels/9.level.json"}', 'other levels than shard 0'],
      [',"file":{}}', 'was changed: it is not as gq writes it'],
    ]) {
      restore();
      writeResult(set, 0, [header, `${first.slice(0, -1)}${end}`, ...rest]);
      expect((await attack([2, 3])).stderr).toContain(message);
    }
  });

  it('leaves a result that is there', async () => {
    restore();
    const { stderr, code } = await runShard(set, '2/3');
    expect(code).toBe(0);
    expect(stderr).toMatch(/out\/shard-1\.ndjson: already there: \d+ of 24 levels/);
    expect(readFileSync(path(1))).toEqual(kept.get(1));
  });
});

describe('a run that a search has found', () => {
  let searched: TestSet;
  beforeAll(async () => {
    // two levels without a run, and one whose own run does not complete it
    const texts = [{ runs: [] }, { name: 'Second', runs: [] }, { runs: [{ name: 'short', holds: [[0, 1]] }] }].map((more) =>
      fallThrough({ blackHole: { x: 300, y: 0 }, ...more }),
    );
    searched = await makeSet(texts);
  });
  afterAll(() => searched.remove());

  /** Does the plan, changes the results of all levels, and merges with all replays. */
  async function mergeChanged(
    change: (result: Record<string, unknown>) => Record<string, unknown>,
    ...options: readonly string[]
  ): Promise<Result> {
    rmSync(join(searched.directory, 'out'), { recursive: true, force: true });
    await planSet(searched, 1, ...options);
    expect((await runShard(searched, 0)).code).toBe(0);
    const [header, ...lines] = resultLines(searched, 0).slice(0, -1);
    const records = lines.map((line) => JSON.parse(line) as RecordLine);
    writeResult(searched, 0, [header, ...records.map((record) => JSON.stringify({ ...record, result: change(record.result) }))]);
    return merge(searched, '--replay', 'all');
  }

  itQuick('is played, and everything that follows from it is compared', async () => {
    const solve = ['--solve', '--effort', '200000'];
    const truth = await mergeChanged((result) => result, ...solve);
    expect(truth.stderr).toContain('3 good results repeated: as recorded');
    expect(truth.stdout).toContain('in a run that a search found');
    const lies: ((result: Record<string, unknown>) => Record<string, unknown>)[] = [
      (result) => ({ ...result, problems: [] }),
      (result) => ({ ...result, name: 'Other' }),
      (result) => ({ ...result, report: { ...(result.report as object), hash: '00' } }),
      (result) => ({ ...result, allow: { 'found-run': 'fine' } }),
      (result) => ({ ...result, found: [[0, 1]] }),
      (result) => ({ ...result, found: 'none' }),
    ];
    for (const lie of lies) expect(await mergeChanged(lie, ...solve)).toMatchObject({ code: 3, stdout: '' });
  });

  it('is a lie in a plan without a search', async () => {
    const found = { verdict: 'completable', found: [[0, 120]], problems: [] };
    const { code, stdout, stderr } = await mergeChanged((result) => ({ ...result, ...found }));
    expect({ code, stdout }).toEqual({ code: 3, stdout: '' });
    expect(stderr).toMatch(/recorded as good, but it is (unproven|broken)/);
  });
});
