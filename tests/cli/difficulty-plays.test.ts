import { readFileSync, symlinkSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { afterAll, describe, expect, it } from 'vitest';
import { inOrderOfPlay } from '../../cli/io/level-names.ts';
import { encodePlay, playToText } from '../../game/index.ts';
import { type DifficultyReport, difficultyReportSchema, type Hold, readLevel } from '../../schema/index.ts';
import { playedBy } from '../check/played.ts';
import { itDeep, itQuick } from '../depth.ts';
import { fallThrough, gq, makeFiles } from './gq.ts';

function levelOf(text: string) {
  const read = readLevel(Buffer.from(text));
  if (!read.ok) throw new Error('not a valid level');
  return read.level;
}

const NOVA = [{ x: 300, y: 0, radius: 20 }];
const files = {
  'pack/first.level.json': fallThrough({ novae: NOVA }),
  'pack/second.level.json': fallThrough({ name: 'Second', blackHole: { x: 190, y: 0 } }),
  'twin.level.json': fallThrough({ name: 'Twin', novae: NOVA }),
  'other.level.json': fallThrough({ blackHole: { x: 180, y: 0 } }),
};
const first = playedBy(levelOf(files['pack/first.level.json']));
const second = playedBy(levelOf(files['pack/second.level.json']));
const elsewhere = playedBy(levelOf(files['other.level.json']));

const HOLD: readonly Hold[] = [[0, 600]];
/** Never falls, so that the player leaves. */
const NONE: readonly Hold[] = [];
const plays = {
  'plays/ann/1.gqr': first(NONE, 30),
  'plays/ann/2.gqr': first(NONE, 90),
  'plays/ann/10.gqr': first(HOLD),
  'plays/bob/a.gqr': first(HOLD),
  'plays/bob/deep/b.gqr': second(HOLD),
  'plays/nobody.gqr': first([[5, 600]]),
  'plays/other.gqr': elsewhere(HOLD),
};
const lie = { ...first(HOLD), claim: { ...first(HOLD).claim, tick: 3 }, holds: [[0, 3] as Hold] };
const lineOf = (id: string, subject: string, play: ReturnType<typeof first>) =>
  JSON.stringify({ id, subject, play: playToText(encodePlay(play)) });

const { directory: cwd, remove } = makeFiles({
  ...files,
  ...Object.fromEntries(Object.entries(plays).map(([name, play]) => [name, encodePlay(play)])),
  'plays/ann/11.gqr': encodePlay(plays['plays/ann/1.gqr']).subarray(0, 50),
  'plays/ann/12.gqr': encodePlay(lie),
  'two/arcade.gqr': encodePlay(playedBy(levelOf(files['pack/second.level.json']), 'arcade')(HOLD)),
  'two/precise.gqr': encodePlay(second(HOLD)),
  'old.gqr': encodePlay({ ...lie, engine: '0'.repeat(16), level: '0'.repeat(64) }),
  'plays/readme.txt': 'hello',
  'lines.ndjson': [
    lineOf('x', 'ann', plays['plays/ann/1.gqr']),
    '',
    lineOf('y', 'ann', plays['plays/ann/2.gqr']),
    lineOf('z', 'ann', plays['plays/ann/10.gqr']),
    lineOf('z', 'bob', plays['plays/bob/a.gqr']),
    '{"play": 1}',
    playToText(encodePlay(plays['plays/nobody.gqr'])),
  ].join('\r\n'),
  'none/readme.txt': '',
  'blank.ndjson': '\n\n',
  'gone/play.gqr': '',
});
afterAll(remove);

interface Reported {
  readonly code: number | null;
  readonly stdout: string;
  readonly stderr: string;
  readonly report: DifficultyReport;
}

async function difficulty(...args: string[]): Promise<Reported> {
  const { code, stdout, stderr } = await gq(['difficulty', ...args, '--effort', '1000', '--format', 'json'], { cwd });
  return { code, stdout, stderr, report: difficultyReportSchema.parse(JSON.parse(stdout)) };
}

describe('gq difficulty --plays', () => {
  itQuick('counts plays of the accuracy at which it measures, and names the others', async () => {
    const counted = async (...args: string[]) => {
      const { stderr, report } = await difficulty('pack/second.level.json', '--plays', 'two', ...args);
      const [{ players }] = report.levels;
      return { attempts: players?.attempts, refused: players?.refused.map(({ verdict }) => verdict), stderr };
    };
    expect(await counted()).toMatchObject({ attempts: 1, refused: ['other-accuracy'] });
    // within a second no run completes the level, so that nothing is measured
    const brief = ['--max-time', '1'];
    expect(await counted(...brief)).toMatchObject({ attempts: 0, refused: ['other-accuracy', 'too-long'] });
    expect(await counted('--accuracy', 'arcade', ...brief)).toMatchObject({
      attempts: 0,
      refused: ['too-long', 'other-accuracy'],
    });
    expect(await counted('--accuracy', 'fast', ...brief)).toMatchObject({
      attempts: 0,
      refused: ['other-accuracy', 'other-accuracy'],
    });
  });

  itQuick(
    'says how players fare, takes folders for players in natural order, and has the same result for any number of threads',
    async () => {
      const args = ['pack/first.level.json', '--plays', 'plays'];
      const { code, stdout, report } = await difficulty(...args, '--jobs', '1');
      expect(code).toBe(0);
      expect((await difficulty(...args, '--jobs', '3')).stdout).toBe(stdout);
      expect(report.plays).toMatchObject({ found: 9, ignoredFiles: 1 });
      // other.gqr and the one for the second level
      expect(report.plays?.elsewhere.map(({ count }) => count)).toEqual([1, 1]);
      expect(report.plays?.refused.map(({ play, verdict }) => [play, verdict])).toEqual([['plays/ann/11.gqr', 'malformed']]);
      const [{ players }] = report.levels;
      expect(players).toMatchObject({ attempts: 5, successes: 3, share: 0.6, players: 2, playersWhoSucceed: 2 });
      expect(players?.refused.map(({ play, verdict }) => [play, verdict])).toEqual([['plays/ann/12.gqr', 'claim-differs']]);
      expect(players?.byAttempt.map(({ attempts, successes, first: once }) => [attempts, successes, once])).toEqual([
        [2, 1, 1],
        [1, 0, 0],
        [1, 1, 1],
      ]);
      expect(players?.failures.map(({ play, cause, tick }) => [play, cause.kind, tick])).toEqual([
        ['plays/ann/1.gqr', 'left', 30],
        ['plays/ann/2.gqr', 'left', 90],
      ]);
      // one press of two players in five attempts: the fit says how little it rests on
      expect(players?.fit).toMatchObject({ players: 2, attempts: 4, forecast: { parameters: { motorMs: 20 } } });
      expect(players?.fit?.scale.low).toBeLessThanOrEqual(players?.fit?.scale.value ?? 0);
      expect(players?.fit?.scale.low).toBeLessThan(players?.fit?.scale.high ?? 0);
      expect(players?.reference).toEqual({ name: 'hold', holds: report.levels[0].measured?.run.holds });
    },
  );

  itDeep('reads the same from lines, with the player that each line names', async () => {
    const folder = await difficulty('pack/first.level.json', '--plays', 'plays', '--jobs', '1');
    const lines = await difficulty('pack/first.level.json', '--plays', 'lines.ndjson', '--jobs', '1');
    const bare = ({ report }: Reported) => {
      const { players } = report.levels[0];
      return JSON.stringify({ ...players, refused: [], failures: [] }).replaceAll(/"play":"[^"]*"/g, '');
    };
    expect(bare(lines)).toBe(bare(folder));
    expect(lines.report.plays?.refused).toEqual([
      { play: 'lines.ndjson:6', verdict: 'malformed', message: expect.stringMatching(/^expected \{"id"/) },
    ]);
    expect(lines.report.levels[0].players?.failures.map(({ play }) => play)).toEqual([
      'lines.ndjson:1 (x)',
      'lines.ndjson:3 (y)',
    ]);
  });

  itDeep('counts a file once that two paths lead to', async () => {
    const { report } = await difficulty('pack', '--plays', 'plays', '--plays', 'plays/ann', '--jobs', '1');
    expect(report.plays?.found).toBe(9);
    expect(report.levels.map(({ players }) => players?.attempts)).toEqual([5, 1]);
  });

  itDeep('adds nothing to the report without plays', async () => {
    const { report } = await difficulty('pack', '--jobs', '1');
    expect(Object.keys(report)).toEqual(['version', 'levels']);
    for (const level of report.levels) expect(Object.keys(level)).not.toContain('players');
  });

  itQuick('prints what players teach below the difficulty, and names plays that do not count', async () => {
    const { code, stdout, stderr } = await gq(['difficulty', 'pack/first.level.json', '--plays', 'plays', '--jobs', '1'], {
      cwd,
    });
    expect(code).toBe(0);
    for (const line of [
      /^players {5}5 attempts of 2 players: 3 succeed, 60\.0 % \(.*\)$/m,
      /^attempt 1 {3}1 of 2 succeed, 50\.0 % \(.*\); 1 for the first time$/m,
      /^failures {4}left 2 \(100 %\)$/m,
      /^way 1 {7}asteroid 1: 3, 100 % of the successes; as run "hold"; the quickest .* s, plays\/ann\/10\.gqr$/m,
      /^the start +5 +2 +40\.0 % .*$/m,
      /^9 plays: 5 count, 2 are not what they claim or can't be read, 2 are of other levels or versions \(2 of them\); 1 other file ignored$/m,
    ]) {
      expect(stdout).toMatch(line);
    }
    expect(stderr).toMatch(/^plays\/ann\/11\.gqr: malformed: byte \d+: .*cut off\n/);
    expect(stderr).toMatch(/^plays\/ann\/12\.gqr: claim-differs: expected completed at tick 3 /m);
  });

  itDeep('prints a table for several levels, those that players succeed at first', async () => {
    const { stdout } = await gq(['difficulty', 'pack', '--plays', 'plays', '--jobs', '1'], { cwd });
    const rows = [...stdout.matchAll(/^ +(\d) +(\d) +([\d.]+ %) .*(pack\/\w+)/gm)].map(([, ...cells]) => cells);
    expect(rows).toEqual([
      ['1', '1', '100 %', 'pack/second'],
      ['5', '2', '60.0 %', 'pack/first'],
    ]);
  });

  itQuick('counts and names a play once, for two files with the same level, too', async () => {
    const args = ['difficulty', 'pack/first.level.json', 'twin.level.json', '--plays', 'plays/ann', '--jobs', '1'];
    const { stdout, stderr } = await gq(args, { cwd });
    expect(
      [...stdout.matchAll(/^ +(\d) .* (\S+)\.level\.json$/gm)].map(([, attempts, level]) => [attempts, level]),
    ).toContainEqual(['3', 'twin']);
    expect(stdout).toMatch(/^5 plays: 3 count, 2 are not what they claim or can't be read$/m);
    expect(stderr.match(/ann\/12\.gqr: claim-differs/g)).toHaveLength(1);
  });

  itQuick('draws where players fail, with a ring around each cluster', async () => {
    const many = Object.fromEntries(
      [0, 1, 2, 3, 4].map((i): [string, Uint8Array] => [`${i}.gqr`, encodePlay(first(NONE, 30 + i))]),
    );
    const made = makeFiles({ 'a.level.json': files['pack/first.level.json'], ...many });
    const args = ['difficulty', '.', '--plays', '.', '--picture', 'where.svg', '--jobs', '1'];
    const { code, stderr, stdout } = await gq(args, { cwd: made.directory });
    expect({ code, stderr }).toEqual({ code: 0, stderr: 'wrote where.svg\n' });
    expect(stdout).toContain('place 1     left at 0, 0 (spread 0 px): 5, 100 % of the failures\n');
    const svg = readFileSync(join(made.directory, 'where.svg'), 'utf8');
    made.remove();
    expect(svg).toMatch(/^<svg [^>]*><title>Where players of Straight through fail<\/title><desc>5 attempts: 0 % succeed/);
    expect(svg.match(/data-kind="failures"/g)).toHaveLength(1);
    expect(svg).toMatch(/data-kind="failure-rings"[^>]*><circle [^>]*><circle /);
  });

  itQuick('draws no play that succeeds', async () => {
    const args = ['difficulty', 'pack/first.level.json', '--plays', 'plays', '--picture', 'few.svg', '--jobs', '1'];
    expect((await gq(args, { cwd })).code).toBe(0);
    const [drawn] = /data-kind="failures".*?<\/g>/.exec(readFileSync(join(cwd, 'few.svg'), 'utf8')) ?? [''];
    // one square and one cross: both failures are at the start
    expect(drawn.match(/M/g)).toHaveLength(2);
  });

  itQuick('names a play of another engine, whatever its level is', async () => {
    const { report } = await difficulty('pack/first.level.json', '--plays', 'old.gqr', '--jobs', '1');
    expect(report.plays).toMatchObject({ found: 1, elsewhere: [], refused: [{ play: 'old.gqr', verdict: 'unknown-engine' }] });
  });

  itQuick('says that no play is of a level, and measures it all the same', async () => {
    const { code, report } = await difficulty('pack/second.level.json', '--plays', 'lines.ndjson', '--jobs', '1');
    expect([code, report.levels[0].players?.attempts, report.levels[0].players?.noise]).toEqual([0, 0, null]);
    expect(report.levels[0].measured).not.toBeNull();
  });

  itQuick('ends with exit code 2 for a play that can not be read, and counts the others', async () => {
    symlinkSync('nowhere', join(cwd, 'plays/bob/broken.gqr'));
    const { code, stderr, report } = await difficulty('pack/first.level.json', '--plays', 'plays/bob', '--jobs', '1');
    expect([code, report.levels[0].players?.attempts]).toEqual([2, 1]);
    expect(stderr).toMatch(/^error: plays\/bob\/broken\.gqr: can't be read: /);
  });

  it.each([
    ['--plays nowhere', 'nowhere: no such file'],
    ['--plays none', 'none: the directory contains no *.gqr, *.ndjson or *.jsonl, only 1 other file\n'],
    ['--plays blank.ndjson', 'blank.ndjson: no line is a play'],
    ['--plays plays --picture where.svg', '--picture draws one level: expected the path of one level file, found 2'],
    ['--plays plays --picture where.png', '--picture where.png: expected a name that ends in .svg'],
    ['--picture where.svg', '--picture has no effect without --plays'],
  ])('gq difficulty pack %s: exit code 2 and a message that says what was expected', async (args, message) => {
    const { code, stdout, stderr } = await gq(['difficulty', 'pack', ...args.split(' ')], { cwd });
    expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
    expect(stderr).toContain(message);
  });
});

describe('the natural order of names', () => {
  it('takes digits for numbers', () => {
    const names = ['a/10.gqr', 'a/9.gqr', 'a/b.gqr', 'a/2024-01-02T10.gqr', 'a/2024-01-02T9.gqr', 'a/09.gqr'];
    expect(names.sort(inOrderOfPlay)).toEqual([
      'a/09.gqr',
      'a/9.gqr',
      'a/10.gqr',
      'a/2024-01-02T9.gqr',
      'a/2024-01-02T10.gqr',
      'a/b.gqr',
    ]);
  });

  it('is an order', () => {
    const name = fc.array(fc.constantFrom('a', 'b', '0', '1', '10', '9'), { maxLength: 5 }).map((parts) => parts.join(''));
    fc.assert(
      fc.property(name, name, name, (a, b, c) => {
        expect(Math.sign(inOrderOfPlay(a, b))).toBe(-Math.sign(inOrderOfPlay(b, a)) + 0);
        if (inOrderOfPlay(a, b) === 0) expect(a).toBe(b);
        if (inOrderOfPlay(a, b) <= 0 && inOrderOfPlay(b, c) <= 0) expect(inOrderOfPlay(a, c)).toBeLessThanOrEqual(0);
      }),
    );
  });
});

it('the report schema that is published knows the keys', () => {
  const schema = readFileSync(new URL('../../schema/reports/difficulty.schema.json', import.meta.url), 'utf8');
  expect(JSON.parse(schema).properties).toHaveProperty('plays');
});
