import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { afterAll, describe, expect, it } from 'vitest';
import { jobOf } from '../../cli/fleet/index.ts';
import { challengeFor, levelHash, playToText } from '../../game/index.ts';
import { difficultyReportSchema, solveSetReportSchema, type VerifyReport, verifyReportSchema } from '../../schema/index.ts';
import { fallThrough, gq, makeFiles } from '../cli/gq.ts';
import { changed as changedPlay, playOfRun } from '../cli/plays.ts';
import { isDeep, isHunt, itDeep, itQuick } from '../depth.ts';
import { shipped } from '../levels/shipped-pack.ts';
import { once } from '../once.ts';
import { changed, placesIn } from './mistakes.ts';

// What commands other than check do with a set: the same as with single files, and in shards the same as in one process.

const KEY = 'a secret that is long enough';
const first = shipped('first-pull');
const swing = shipped('first-swing');
const withoutRuns = (text: string): string => JSON.stringify({ ...JSON.parse(text), runs: [] });
const levels: Readonly<Record<string, string>> = {
  'a.level.json': first.text,
  'b.level.json': withoutRuns(swing.text),
  'c.level.json': fallThrough({ name: 'Runless', runs: [] }),
  // nothing is near enough to pull her
  'd.level.json': fallThrough({ name: 'Far away', range: 20, runs: [] }),
  'e.level.json': fallThrough({ name: 5 }),
};
const good = playOfRun('first-pull');
const plays: Readonly<Record<string, Uint8Array>> = {
  'good.gqr': good,
  'more/claim.gqr': changedPlay(good, -1),
  'more/cut.gqr': good.subarray(0, 40),
  'more/stale.gqr': changedPlay(good, 20),
  'other.gqr': playOfRun('first-swing'),
};
const inFolder = <T>(folder: string, files: Readonly<Record<string, T>>): Record<string, T> =>
  Object.fromEntries(Object.entries(files).map(([name, content]) => [`${folder}/${name}`, content]));

const files = makeFiles({
  ...inFolder('set', levels),
  ...inFolder('plays', plays),
  'levels/a.level.json': first.text,
  'levels/b.level.json': swing.text,
  'set.ndjson': Object.values(levels)
    .map((text) => `${JSON.stringify(JSON.parse(text))}\n`)
    .join(''),
  'plays.ndjson.gz': gzipSync(
    Object.values(plays)
      .map((bytes, i) => `${i % 2 === 0 ? playToText(bytes) : JSON.stringify({ id: `play ${i}`, play: playToText(bytes) })}\n`)
      .join(''),
  ),
  'key.txt': `${KEY}\n`,
});
const cwd = files.directory;
afterAll(files.remove);

const run = async (code: number | null, ...args: readonly string[]): Promise<string> => {
  const ended = await gq(args, { cwd });
  expect(ended.code, ended.stderr).toBe(code);
  return ended.stdout;
};

let plans = 0;

/** Plans, does and merges a set. @returns the report as JSON */
async function inShards(
  job: string,
  shards: number,
  code: number,
  args: readonly string[],
  replay: 'all' | 'none' = 'all',
): Promise<string> {
  const plan = `plan-${++plans}.json`;
  await run(0, 'plan', ...args, '--for', job, '--shards', `${shards}`, '-o', plan);
  for (let i = shards - 1; i >= 0; i--) await run(0, job, '--plan', plan, '--shard', `${i}`, '--out', `out-${plans}`);
  return run(code, 'merge', `out-${plans}`, '--plan', plan, '--format', 'json', '--replay', replay);
}

/** The set in one shard, whose good results are all repeated, and the number of its plan; some levels of it in the quick set. */
const inOneShard = once(async (job: string): Promise<{ readonly report: string; readonly plan: number }> => {
  const set = isDeep ? ['set'] : ['set/a.level.json', 'set/c.level.json', 'set/e.level.json'];
  const report = await inShards(job, 1, 1, job === 'verify' ? ['plays'] : [...set, ...EFFORT]);
  return { report, plan: plans };
});

const withoutTimes = (report: string): string => report.replace(/"(seconds|ms)":[-+.e\d]+/g, '"$1":0');

const EFFORT = ['--effort', '200000'];

/** What a replay takes from a result: runs that a search has found, and how much it has tried. */
const BEGINNINGS = /^solved\.(holds|effort)|\.runs\.0\.run\.holds/;

describe('gq solve on a set', () => {
  itDeep('gives each level what gq solve gives it alone, and in shards the same bytes for any number of them', async () => {
    const together = await run(1, 'solve', 'set', ...EFFORT, '--format', 'json');
    const report = solveSetReportSchema.parse(JSON.parse(together));
    expect(report.levels.map(({ verdict }) => verdict)).toEqual(['found', 'found', 'found', 'impossible', 'invalid']);
    expect(report.summary).toEqual({ found: 3, impossible: 1, 'not-found': 0, invalid: 1, crashed: 0 });
    for (const { file, solved, verdict } of report.levels.slice(0, 4)) {
      const alone = await run(verdict === 'found' ? 0 : 1, 'solve', file, ...EFFORT, '--format', 'json', '--jobs', '2');
      expect(withoutTimes(alone), file).toBe(withoutTimes(`${JSON.stringify(solved)}\n`));
    }
    expect((await inOneShard('solve')).report).toBe(withoutTimes(together));
    expect(await inShards('solve', 3, 1, ['set', ...EFFORT], 'none')).toBe(withoutTimes(together));
  });

  itDeep('searches for several runs with every option of the search', async () => {
    const options = ['--count', '2', '--objective', 'time', '--minerals', 'all', '--seed', '3', '--max-time', '20', ...EFFORT];
    const alone = JSON.parse(await run(0, 'solve', 'set/b.level.json', ...options, '--format', 'json'));
    const { levels: set } = JSON.parse(await inShards('solve', 2, 1, ['set.ndjson', ...options]));
    expect(set[1].file).toBe('set.ndjson#2');
    expect(JSON.parse(withoutTimes(JSON.stringify(set[1].solved)))).toEqual(JSON.parse(withoutTimes(JSON.stringify(alone))));
    expect(set[1].solved.solutions.length).toBeGreaterThan(0);
  });

  itQuick('says in words what became of each level', async () => {
    const { code, stdout } = await gq(['solve', 'set.ndjson', '--minerals', '2', ...EFFORT], { cwd });
    expect(code).toBe(1);
    expect(stdout).toMatch(/^not-found +set\.ndjson#1 +it has only 0 minerals of the 2 required$/m);
    expect(stdout).toMatch(/^invalid +set\.ndjson#5 +not a valid level$/m);
    expect(stdout).toMatch(/^5 levels: 1 found, 3 not-found, 1 invalid$/m);
  });

  it('refuses to write runs into several levels', async () => {
    const { code, stderr } = await gq(['solve', 'set.ndjson', '--write'], { cwd });
    expect(code).toBe(2);
    expect(stderr).toBe('error: --write is for a single level file: leave it out, or solve the levels one at a time\n');
  });
});

describe('gq difficulty on a set', () => {
  itDeep('gives the report of gq difficulty on files, byte by byte, for any number of shards', async () => {
    const direct = await run(1, 'difficulty', 'set', ...EFFORT, '--format', 'json');
    expect(difficultyReportSchema.parse(JSON.parse(direct)).levels.filter(({ measured }) => measured !== null)).toHaveLength(3);
    expect((await inOneShard('difficulty')).report).toBe(direct);
    expect(await inShards('difficulty', 4, 1, ['set', ...EFFORT], 'none')).toBe(direct);
    const packed = await run(1, 'difficulty', 'set.ndjson', ...EFFORT, '--format', 'json');
    const named = Object.keys(levels).reduce((text, name, i) => text.replace(`set/${name}`, `set.ndjson#${i + 1}`), direct);
    const withoutPlaces = (text: string): unknown =>
      JSON.parse(text, (key, value) => (['problems', 'name'].includes(key) ? undefined : value));
    expect(withoutPlaces(packed)).toEqual(withoutPlaces(named));
  });

  itQuick('says how many levels have which grade', async () => {
    const stdout = await run(1, 'difficulty', 'set.ndjson', ...EFFORT);
    expect(stdout).toMatch(/^5 levels: 3 measured: \d gentle, \d easy, \d medium, \d hard, \d brutal$/m);
    expect(stdout).toMatch(/^set\.ndjson#4: not measured: proved impossible: /m);
  });

  it('refuses pictures and plays of packs', async () => {
    for (const options of [
      ['--svg', 'a.svg'],
      ['--plays', 'plays'],
    ]) {
      const { code, stderr } = await gq(['difficulty', 'set.ndjson', ...options], { cwd });
      expect(code).toBe(2);
      expect(stderr).toBe(
        `error: set.ndjson is a pack, and ${options[0]} is for level files: leave it out, or unpack the levels\n`,
      );
    }
  });
});

describe('gq verify on a set', () => {
  const linesOf = (text: string): VerifyReport[] =>
    text
      .split('\n')
      .slice(0, -1)
      .map((line) => verifyReportSchema.parse(JSON.parse(line)));

  itQuick('gives the lines of gq verify on files and on standard input, byte by byte, for any number of shards', async () => {
    const direct = await run(1, 'verify', 'plays', '--format', 'json');
    expect(linesOf(direct).map(({ verdict }) => verdict)).toEqual(['ok', 'claim-differs', 'malformed', 'stale-level', 'ok']);
    // a stale play is not tried on other levels, as which of them are tried would depend on the shard
    const untried = direct
      .replace(/(hash of the play); its inputs [^"]+/, '$1: it was played on another version of a level, or on another level')
      .replace(/"mayBe":"[^"]+"/, '"mayBe":null');
    expect((await inOneShard('verify')).report).toBe(untried);
    expect(await inShards('verify', 3, 1, ['plays'])).toBe(untried);
    const lines = Object.values(plays)
      .map((bytes, i) => `${i % 2 === 0 ? playToText(bytes) : JSON.stringify({ id: `play ${i}`, play: playToText(bytes) })}\n`)
      .join('');
    const submitted = await gq(['verify', '-'], { cwd, input: lines });
    const asPack = submitted.stdout.replaceAll('"file":null,"line"', '"file":"plays.ndjson.gz","line"');
    expect(linesOf(asPack)).toHaveLength(5);
    expect(await run(1, 'verify', 'plays.ndjson.gz', '--format', 'json')).toBe(asPack);
    expect(await inShards('verify', 2, 1, ['plays.ndjson.gz'])).toBe(asPack);
  });

  it('says in words what each play is', async () => {
    const stdout = await run(1, 'verify', 'plays.ndjson.gz');
    expect(stdout).toContain('ok             plays.ndjson.gz#1\n  First Pull, precise: completed');
    expect(stdout).toContain('claim-differs  plays.ndjson.gz#2 (play 1)\n');
    expect(stdout).toMatch(/\n5 plays: 2 ok, 1 claim-differs, 1 malformed, 1 stale-level\n$/);
  });

  itQuick('compares with the levels and the key that were planned, and with no others', async () => {
    const secret = new TextEncoder().encode(KEY);
    const challenged = playOfRun('first-pull', 0, challengeFor(secret, levelHash(first.level), 2000, 'ann'));
    writeFileSync(
      join(cwd, 'challenged.ndjson'),
      `${JSON.stringify({ play: playToText(challenged), subject: 'ann' })}\n${JSON.stringify({ play: playToText(challenged), subject: 'bob' })}\n`,
    );
    const options = ['--challenge-key', 'key.txt', '--now', '1000', '--levels', 'levels'];
    const report = linesOf(await inShards('verify', 2, 1, ['challenged.ndjson', ...options]));
    expect(report.map(({ challenge }) => challenge)).toEqual(['ok', 'forged']);
    const plan = `plan-${plans}.json`;
    const again = (): ReturnType<typeof gq> => gq(['verify', '--plan', plan, '--shard', '0', '--out', 'again'], { cwd });
    writeFileSync(join(cwd, 'key.txt'), 'another secret that is long');
    const otherKey = await again();
    expect(otherKey.code).toBe(2);
    expect(otherKey.stderr).toContain('--challenge-key key.txt is another key than when the plan was made');
    writeFileSync(join(cwd, 'key.txt'), KEY);
    writeFileSync(join(cwd, 'levels/a.level.json'), `${first.text} `);
    const otherLevel = await again();
    expect(otherLevel.code).toBe(2);
    expect(otherLevel.stderr).toContain('a level that plays are compared with has changed since the plan was made');
    expect(readdirSync(join(cwd, 'again'))).toEqual([]);
    const merged = await gq(['merge', `out-${plans}`, '--plan', plan], { cwd });
    expect(merged.code).toBe(2);
    expect(merged.stderr).toContain('has changed since the plan was made');
    writeFileSync(join(cwd, 'levels/a.level.json'), first.text);
    expect((await again()).code).toBe(0);
  });
});

describe('a plan for a command', () => {
  it('refuses the options of other commands', async () => {
    const refused: [job: string, option: readonly string[], others: string][] = [
      ['check', ['--minerals', 'all'], '--for solve or --for difficulty'],
      ['solve', ['--solve'], '--for check'],
      ['difficulty', ['--count', '2'], '--for solve'],
      ['verify', ['--effort', '5'], '--for check or --for solve or --for difficulty'],
      ['solve', ['--require-slack', '2'], '--for check'],
      ['check', ['--levels', 'levels'], '--for verify'],
    ];
    for (const [job, option, others] of refused) {
      const { code, stderr } = await gq(['plan', 'set', '--shards', '2', '--for', job, ...option, '-o', 'no.json'], { cwd });
      expect(code).toBe(2);
      expect(stderr).toBe(`error: ${option[0]} has no effect on gq ${job}: leave it out, or plan another command: ${others}\n`);
    }
  });

  it('is for that command alone, and names it where results are missing', async () => {
    await run(0, 'plan', 'set', '--for', 'solve', ...EFFORT, '--shards', '2', '-o', 'of-solve.json');
    const wrong = await gq(['difficulty', '--plan', 'of-solve.json', '--shard', '0', '--out', 'wrong'], { cwd });
    expect(wrong).toMatchObject({
      code: 2,
      stderr: 'error: of-solve.json is a plan for gq solve: run gq solve --plan, not gq difficulty\n',
    });
    await run(0, 'solve', '--plan', 'of-solve.json', '--shard', '1', '--out', 'half');
    const { code, stderr } = await gq(['merge', 'half', '--plan', 'of-solve.json'], { cwd });
    expect(code).toBe(2);
    expect(stderr).toContain('gq solve --plan of-solve.json --shard 0 --out ...');
    const junit = await gq(['merge', 'half', '--plan', 'of-solve.json', '--format', 'junit'], { cwd });
    expect(junit).toMatchObject({
      code: 2,
      stderr: 'error: the plan is for gq solve, which has no report junit: expected pretty or json\n',
    });
  });
});

describe('a replay', () => {
  // A replay of difficulty takes half a second: outside of hunts, one in so many changes is tried, in the quick set and in the deep
  // one, which also tries every place of the first result that a replay begins from; the rest is compared with what it ends with.
  it.each([
    ['solve', 35, 11],
    ['difficulty', 469, 157],
    ['verify', 1, 1],
  ])('of gq %s notices any single change of a good result', async (job, quickStride, deepStride) => {
    const { plan } = await inOneShard(job);
    const { settings } = JSON.parse(readFileSync(join(cwd, `plan-${plan}.json`), 'utf8'));
    const records = readFileSync(join(cwd, `out-${plan}`, 'shard-0.ndjson'), 'utf8')
      .split('\n')
      .slice(1, -2)
      .map((line) => JSON.parse(line));
    const { isClaim, openWork } = jobOf(job);
    // the settings have paths of that directory
    const before = process.cwd();
    process.chdir(cwd);
    try {
      const { replay } = await openWork(settings);
      let claims = 0;
      for (const { file, result } of records) {
        if (!isClaim(result)) continue;
        claims++;
        const entry = { name: file, content: readFileSync(file) };
        expect(await replay(entry, result), file).toBe(null);
        for (const [i, path] of placesIn(result).entries()) {
          const begins = isDeep && claims === 1 && BEGINNINGS.test(path.join('.'));
          if (!isHunt && !begins && (i + claims) % (isDeep ? deepStride : quickStride) !== 0) continue;
          const lie = changed(result, path, (holder, key) => {
            const value = holder[key];
            if (typeof value === 'number') holder[key] = value + 1;
            else if (typeof value === 'boolean') holder[key] = !value;
            else if (typeof value === 'string') holder[key] = `${value}x`;
            else holder[key] = value === null ? 1 : null;
          });
          const where = path.join('.');
          // how much was tried is not known without the search, and such records are no claims
          const isFree = /^solved\.effort\.(runs|ticks|seconds)/.test(where);
          const notice = async (): Promise<string | null> => replay(entry, lie as never);
          if (isClaim(lie as never) && !isFree) expect(await notice().catch(() => 'a failure'), where).not.toBe(null);
        }
      }
      expect(claims).toBeGreaterThan(1);
    } finally {
      process.chdir(before);
    }
  });
});
