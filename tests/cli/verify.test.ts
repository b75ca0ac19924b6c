import { cpSync, mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { challengeFor, ENGINE_ID, encodePlay, levelHash, playToText } from '../../game/index.ts';
import { type VerifyReport, verifyReportSchema } from '../../schema/index.ts';
import { playedBy } from '../check/played.ts';
import { shipped } from '../levels/shipped-pack.ts';
import { type Ended, gq, gqProcess, makeFiles } from './gq.ts';
import { changed, playOfRun } from './plays.ts';

const first = shipped('first-pull');
const swing = shipped('first-swing');
const good = playOfRun('first-pull');
const other = playOfRun('first-swing');
const OLD = '0123456789abcdef';
const KEY = 'a secret that is long enough';
const secret = new TextEncoder().encode(KEY);
/** The play of another engine. */
const old = good.slice();
old.set(Buffer.from(OLD, 'hex'), 5);

const moved = { ...JSON.parse(swing.text), blackHole: { ...swing.level.blackHole, radius: 19 } };
const files = makeFiles({
  'levels/a.level.json': first.text,
  'levels/b.level.json': swing.text,
  'levels/broken.level.json': '{',
  'levels/z-copy.level.json': first.text,
  'later/b.level.json': JSON.stringify(moved),
  'plays/good.gqr': good,
  'plays/sub/other.gqr': other,
  'bad/claim.gqr': changed(good, -1),
  'bad/cut.gqr': good.subarray(0, 40),
  'bad/empty.gqr': '',
  'bad/huge.gqr': new Uint8Array(70_000).fill(0x89),
  'bad/level.gqr': changed(good, 20),
  'bad/old.gqr': old,
  'bad/pointer.gqr': 'version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 98\n',
  'bad/text.gqr': '{"id": 1}',
  'none/readme.txt': '',
  'key.txt': `${KEY}\n`,
  'short.txt': 'short',
});
const cwd = files.directory;
afterAll(files.remove);

const reports = ({ stdout }: Ended): VerifyReport[] =>
  stdout
    .split('\n')
    .filter((line) => line !== '')
    .map((line) => verifyReportSchema.parse(JSON.parse(line)));

describe('gq verify, accuracies', () => {
  const arcade = encodePlay(playedBy(swing.level, 'arcade')(swing.level.runs[0].holds));
  const folder = makeFiles({
    'levels/b.level.json': swing.text,
    'arcade.gqr': arcade,
    'precise.gqr': other,
    'in-arcade/gq.config.json': '{ "accuracy": "arcade" }',
    'in-arcade/levels/b.level.json': swing.text,
  });
  afterAll(folder.remove);
  const verdicts = async (at: string, ...args: string[]) => {
    const ended = await gq(['verify', ...args, '--format', 'json'], { cwd: join(folder.directory, at) });
    return [ended.code, ...reports(ended).map(({ verdict }) => verdict)];
  };

  it('are chosen by who verifies, never by the sender', async () => {
    expect(await verdicts('.', 'arcade.gqr', 'precise.gqr')).toEqual([1, 'other-accuracy', 'ok']);
    expect(await verdicts('.', 'arcade.gqr', 'precise.gqr', '--accuracy', 'arcade')).toEqual([1, 'ok', 'other-accuracy']);
    expect(await verdicts('.', 'arcade.gqr', 'precise.gqr', '--accuracy', 'any')).toEqual([0, 'ok', 'ok']);
    expect(await verdicts('in-arcade', '../arcade.gqr', '../precise.gqr')).toEqual([1, 'ok', 'other-accuracy']);
    expect(await verdicts('in-arcade', '../arcade.gqr', '--accuracy', 'precise')).toEqual([1, 'other-accuracy']);
  });

  it('are part of a plan', async () => {
    const run = (...args: string[]) => gq(args, { cwd: folder.directory });
    const plan = ['plan', 'arcade.gqr', 'precise.gqr', '--for', 'verify', '--shards', '1', '--force'];
    for (const [accuracy, expected] of [
      ['arcade', ['ok', 'other-accuracy']],
      ['any', ['ok', 'ok']],
    ] as const) {
      expect((await run(...plan, '--accuracy', accuracy)).stderr).not.toContain('error');
      await run('verify', '--plan', 'plan.json', '--shard', '0', '--out', accuracy);
      const merged = await run('merge', accuracy, '--plan', 'plan.json', '--format', 'json');
      expect(reports(merged).map(({ verdict }) => verdict)).toEqual(expected);
    }
    const refused = await run('plan', 'levels', '--shards', '1', '--accuracy', 'any');
    expect(refused).toMatchObject({ code: 2, stderr: expect.stringContaining('--accuracy any is for plays') });
  });
});

describe('gq verify', () => {
  it('says of every play in files and folders what it is, in order', async () => {
    const { code, stdout, stderr } = await gq(['verify', 'plays', './plays/good.gqr'], { cwd });
    expect(stderr).toBe('warning: levels/broken.level.json: not a valid level; no play is compared with it\n');
    expect(stdout).toBe(
      [
        'ok             plays/good.gqr',
        `  First Pull, precise: completed at tick 981 with 0 minerals, after 16.334 s`,
        `  repeats the level's own run "solution"`,
        'ok             plays/sub/other.gqr',
        `  First Swing, precise: completed at tick 674 with 3 minerals, after 11.219 s`,
        `  repeats the level's own run "solution"`,
        '2 plays: 2 ok',
        '',
      ].join('\n'),
    );
    expect(code).toBe(0);
  });

  it('gives each verdict its reason, and ends with 1', async () => {
    const ended = await gq(['verify', 'bad', '--levels', 'levels/a.level.json', '--format', 'json'], { cwd });
    expect(ended.code).toBe(1);
    const found = Object.fromEntries(
      reports(ended).map(({ file, verdict, message }) => [file?.slice(4, -4), [verdict, message]]),
    );
    expect(found).toEqual({
      claim: ['claim-differs', 'the replay differs from the play: first between tick 0 and 600 (0.00 s and 10.00 s)'],
      cut: ['malformed', 'byte 13: expected the hash of the level, 32 bytes, found only 27 bytes: the file is cut off'],
      empty: ['malformed', 'byte 0: expected a play, which begins with the bytes 89 47 51 52, found no bytes'],
      huge: ['too-long', expect.stringMatching(/^expected a play of at most 65536 bytes, found /)],
      level: [
        'stale-level',
        'no level among the one given has the hash of the play; its inputs lead to just what it claims on levels/a.level.json, which may be another version of its level',
      ],
      old: ['unknown-engine', `expected a play of engine ${ENGINE_ID}, found one of ${OLD}; --engines DIR looks up older ones`],
      pointer: [
        'malformed',
        'byte 0: expected a play, found a Git LFS pointer (98 bytes are elsewhere). Run git lfs install and git lfs pull, which put the content here.',
      ],
      text: ['malformed', 'expected a play, found text; if its lines are plays: gq verify - < bad/text.gqr'],
    });
  });

  it('says which level a stale play may be of', async () => {
    const ended = await gq(['verify', 'plays', '--levels', 'later', '--levels', 'levels/a.level.json', '--format', 'json'], {
      cwd,
    });
    expect(ended.code).toBe(1);
    expect(reports(ended).map(({ verdict, level }) => [verdict, level?.file, level?.mayBe])).toEqual([
      ['ok', 'levels/a.level.json', null],
      ['stale-level', null, 'later/b.level.json'],
    ]);
  });

  it.each<[string, string[], string]>([
    [
      'a path that matches nothing',
      ['nowhere.gqr', 'none'],
      'nothing was verified: paths match no play\n  nowhere.gqr: no such file or directory',
    ],
    ['a folder without plays', ['none'], '  none: the directory contains no *.gqr\n'],
    ['no levels', ['plays', '--levels', 'none'], 'none: the directory contains no *.level.json'],
    ['standard input beside files', ['-', 'plays'], 'the path - reads plays from standard input'],
    [
      'engines that are not there',
      ['plays', '--engines', 'x'],
      '--engines x: no such file or directory; expected a directory of engines',
    ],
    [
      'a file of engines',
      ['plays', '--engines', 'key.txt'],
      '--engines key.txt: part of its path is a file, not a directory; expected a directory of engines',
    ],
    ['a short key', ['plays', '--challenge-key', 'short.txt'], 'expected a key of 16 to 4096 bytes, found 5'],
    ['a time without a key', ['plays', '--now', '5'], '--now has no effect without --challenge-key'],
    ['too many ticks', ['plays', '--max-ticks', '216001'], 'expected a number of ticks: a whole number from 1 to 216000'],
  ])('refuses %s', async (_, args, message) => {
    const { code, stdout, stderr } = await gq(['verify', ...args], { cwd });
    expect([code, stdout]).toEqual([2, '']);
    expect(stderr).toContain(message);
  });

  it('refuses what is longer or more work than is allowed', async () => {
    for (const [limit, message] of [
      [['--max-ticks', '980'], 'expected a play of at most 980 ticks, found one of 981'],
      [['--max-work', '1'], 'expected a replay within the limit, found more work than 1 pieces of motion'],
    ] as const) {
      const ended = await gq(['verify', 'plays/good.gqr', '--format', 'json', ...limit], { cwd });
      expect([ended.code, ...reports(ended).map((one) => [one.verdict, one.message])]).toEqual([1, ['too-long', message]]);
    }
  });
});

/** Runs gq with this standard input. */
const piped = (input: string, ...args: string[]): Promise<Ended> => gq(['verify', '-', ...args], { cwd, input });

/** Lets a process say at its end how many threads it has started. */
const COUNTS_THREADS = {
  NODE_OPTIONS: `--import data:text/javascript,${encodeURIComponent(`
    import { syncBuiltinESMExports } from 'node:module';
    import threads from 'node:worker_threads';
    const { Worker, isMainThread } = threads;
    let count = 0;
    threads.Worker = class extends Worker {
      constructor(...args) {
        super(...args);
        count++;
      }
    };
    syncBuiltinESMExports();
    if (isMainThread) process.on('exit', () => process.stderr.write(count + ' threads\\n'));
  `)}`,
};

describe('gq verify -', () => {
  it('reads a play a line and answers in the same order', async () => {
    const lines = [
      JSON.stringify({ id: 'a', play: playToText(good), more: 1 }),
      '',
      playToText(other),
      JSON.stringify(playToText(good)),
      '{"id": 7}',
      '{"id": [], "play": ""}',
      '[]',
      '{',
      `{"id": 8, "play": "${'A'.repeat(90_000)}"}`,
      'A'.repeat(200_000),
      'not base64url!',
      // no text of base64url has this length; as bytes it would not be too long
      'A'.repeat(70_001),
    ];
    const ended = await piped(`${lines.join('\r\n')}\n${playToText(changed(good, -3))}`, '--jobs', '1');
    expect(ended.code).toBe(1);
    expect(reports(ended).map(({ line, id, verdict }) => [line, id, verdict])).toEqual([
      [1, 'a', 'ok'],
      [3, null, 'ok'],
      [4, null, 'ok'],
      [5, 7, 'malformed'],
      [6, null, 'malformed'],
      [7, null, 'malformed'],
      [8, null, 'malformed'],
      [9, 8, 'too-long'],
      [10, null, 'too-long'],
      [11, null, 'malformed'],
      [12, null, 'malformed'],
      [13, null, 'claim-differs'],
    ]);
  });

  it('takes none of two values for the same key', async () => {
    const [one, two] = [playToText(good), playToText(other)];
    const lines = [
      `{"id":1,"play":"${one}","play":"${two}"}`,
      `{"id":1,"id":2,"play":"${one}"}`,
      `{"play":"${one}","pl\\u0061y":"${one}"}`,
      `  {"play":"${one}","more":{"x":1,"x":1}}`,
      `{"id":1,"play":"${one}","more":[{"x":1},{"x":1}]}`,
      `{"id":1,"play":"${one}","more":1e999}`,
    ];
    const ended = await piped(`${lines.join('\n')}\n`);
    const said = reports(ended).map((report) => [report.verdict, report.message?.replace(/^.*; at /, '')]);
    const twice = (column: number, key: string) => [
      'malformed',
      `column ${column}: this object has the key "${key}" more than once`,
    ];
    expect(said).toEqual([
      twice(19 + one.length, 'play'),
      twice(9, 'id'),
      twice(12 + one.length, 'play'),
      twice(28 + one.length, 'x'),
      ['ok', expect.anything()],
      ['malformed', expect.stringMatching(/^column \d+: the number 1e999 is too large/)],
    ]);
  });

  it('answers a line while it waits for the next', async () => {
    let answers = 0;
    const ended = await gqProcess(['verify', '-'], {
      cwd,
      during({ stdin, stdout }) {
        stdin?.write(`${playToText(good)}\n`);
        stdout?.on('data', () => {
          answers++;
          if (answers === 1) stdin?.write(`${playToText(other)}\n`);
          else stdin?.end();
        });
      },
    });
    expect([ended.code, answers, reports(ended).length]).toEqual([0, 2, 2]);
  });

  it('tries no stale play on other levels: there may be any number of them', async () => {
    const [{ verdict, level }] = reports(await piped(playToText(changed(good, 20))));
    expect([verdict, level?.mayBe]).toEqual(['stale-level', null]);
  });

  it('without a play is an error', async () => {
    expect(await piped('\n\n')).toMatchObject({ code: 2, stderr: expect.stringContaining('standard input has no play') });
  });

  it('gives the same answers with threads, and stops when nobody reads them', async () => {
    const lines = `${playToText(good)}\n${playToText(other)}\n`.repeat(350);
    const [one, two, cut] = await Promise.all([
      piped(lines, '--jobs', '1'),
      gqProcess(['verify', '-', '--jobs', '2'], { cwd, env: COUNTS_THREADS, during: ({ stdin }) => stdin?.end(lines) }),
      gqProcess(['verify', '-', '--jobs', '1'], {
        cwd,
        env: COUNTS_THREADS,
        during({ stdin, stdout }) {
          stdin?.on('error', () => {});
          stdin?.end(lines);
          stdout?.once('data', () => stdout.destroy());
        },
      }),
    ]);
    expect([one.code, one.stdout]).toEqual([0, two.stdout]);
    expect(two.code).toBe(0);
    const places = two.stdout
      .split('\n')
      .map((line) => /"line":(\d+),"id":null,"verdict":"ok".*"levels.([ab])/.exec(line)?.slice(1));
    expect(places).toEqual([...Array.from({ length: 700 }, (_, i) => [`${i + 1}`, i % 2 === 0 ? 'a' : 'b']), undefined]);
    // several batches come before the first thread has started
    expect(two.stderr).toBe(`${one.stderr}2 threads\n`);
    expect(cut).toMatchObject({ code: 0, signal: null, stderr: `${one.stderr}0 threads\n` });
  });

  it('ends on a signal while it waits', async () => {
    const ended = await gqProcess(['verify', '-'], {
      cwd,
      during(child) {
        child.stdin?.write(`${playToText(good)}\n`);
        child.stdout?.once('data', () => child.kill('SIGINT'));
      },
    });
    // without a handler the system ends it, and a shell reports 130
    expect(ended.signal === 'SIGINT' || ended.code === 130).toBe(true);
  });
});

describe('challenges', () => {
  const hash = levelHash(first.level);
  const submit = (challenge: string | null, subject?: string) =>
    JSON.stringify({ play: playToText(playOfRun('first-pull', 0, challenge)), ...(subject !== undefined && { subject }) });

  it('are checked with their key, their time and their player', async () => {
    const lines = [
      submit(challengeFor(secret, hash, 2000)),
      submit(challengeFor(secret, hash, 2000, 'ann'), 'ann'),
      submit(challengeFor(secret, hash, 2000, 'ann'), 'bob'),
      submit(challengeFor(secret, hash, 1999)),
      submit(challengeFor(secret, levelHash(swing.level), 2000)),
      submit(null),
    ];
    const ended = await piped(lines.join('\n'), '--challenge-key', 'key.txt', '--now', '2000');
    expect(reports(ended).map(({ verdict, challenge }) => [verdict, challenge])).toEqual([
      ['ok', 'ok'],
      ['ok', 'ok'],
      ['claim-differs', 'forged'],
      ['claim-differs', 'expired'],
      ['claim-differs', 'forged'],
      ['claim-differs', 'missing'],
    ]);
    expect(ended.code).toBe(1);
  });
});

describe('older engines', () => {
  const dist = join(import.meta.dirname, '../../dist');
  const place = join(cwd, 'engines', OLD, 'dist');

  it('verify the plays that were made with them', async () => {
    for (const room of ['schema', 'engine', 'game']) cpSync(join(dist, room), join(place, room), { recursive: true });
    symlinkSync(join(dist, '../node_modules'), join(cwd, 'engines', OLD, 'node_modules'), 'junction');
    writeFileSync(join(cwd, 'engines', OLD, 'package.json'), '{ "type": "module" }');
    const constant = join(place, 'game/play/engine-id.js');
    writeFileSync(constant, readFileSync(constant, 'utf8').replace(/(ENGINE_ID = ')[0-9a-f]*/, `$1${OLD}`));
    // it had other hashes of levels, too
    const hashes = join(place, 'game/play/level-hash.js');
    const flipped = `export const levelHash = (level) => hashOf(level).replace(/^./, (digit) => (digit === '0' ? '1' : '0'));\n`;
    writeFileSync(hashes, flipped + readFileSync(hashes, 'utf8').replace('export function levelHash(', 'function hashOf('));
    old[13] = old[13] < 0x10 ? old[13] | 0x10 : old[13] & 0x0f;
    writeFileSync(join(cwd, 'bad/old.gqr'), old);
    const ended = await gq(['verify', 'bad/old.gqr', 'plays/good.gqr', '--engines', 'engines', '--format', 'json'], { cwd });
    expect(reports(ended).map(({ verdict, engine, level }) => [verdict, engine, level?.name])).toEqual([
      ['ok', OLD, 'First Pull'],
      ['ok', ENGINE_ID, 'First Pull'],
    ]);
    expect(ended.code).toBe(0);
  });

  it('are named where the one asked for is missing, and must be what their folder says', async () => {
    mkdirSync(join(cwd, 'wrong', OLD), { recursive: true });
    const asked = ['verify', 'bad/old.gqr', '--engines', 'wrong'];
    expect((await gq(asked, { cwd })).stdout).toContain(`found one of ${OLD}; wrong has no engine`);
    symlinkSync(dist, join(cwd, 'wrong', OLD, 'dist'), 'junction');
    expect(await gq(asked, { cwd })).toMatchObject({
      code: 2,
      stderr: expect.stringContaining(`expected engine ${OLD}, as its folder says; found ${ENGINE_ID}`),
    });
  });
});
