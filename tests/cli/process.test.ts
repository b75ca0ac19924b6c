import { execFileSync, spawn } from 'node:child_process';
import { closeSync, constants, mkdirSync, openSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { afterAll, describe, expect } from 'vitest';
import { findLevelFiles } from '../../cli/find/index.ts';
import { describeQuick, itQuick as it, itDeep } from '../depth.ts';
import { interruptAt } from '../interrupted/step.ts';
import { fallThrough, gq, gqCovered, gqProcess, MAIN, makeFiles } from './gq.ts';

// drifting for an hour takes long enough to be interrupted
const drift = fallThrough({
  asteroids: [{ x: 100, y: 0, radius: 16 }],
  runs: Array.from({ length: 40 }, (_, i) => ({ name: `${i}`, holds: [] })),
});
const files = makeFiles({
  ...Object.fromEntries(Array.from({ length: 130 }, (_, i) => [`many/${i}.level.json`, fallThrough({ name: `Level ${i}` })])),
  ...Object.fromEntries(Array.from({ length: 200 }, (_, i) => [`long/${i}.level.json`, drift])),
  'good.level.json': fallThrough(),
});
const cwd = files.directory;
afterAll(files.remove);

const withoutTimes = (json: string): string => json.replace(/"ms":[\d.e-]+/g, '"ms":0');

it('prints its version, and help for every command, on stdout', async () => {
  const { version } = JSON.parse(readFileSync(new URL('../../package.json', import.meta.url), 'utf8'));
  const names = [
    'check',
    'simulate',
    'solve',
    'difficulty',
    'generate',
    'inspect',
    'render',
    'import',
    'fmt',
    'schema',
    'explain',
    'edit',
  ];
  const [short, long, root, ...helps] = await Promise.all([
    gq(['-V']),
    gqProcess(['--version']),
    gq(['--help']),
    ...names.map((name) => gq([name, '--help'])),
    gq(['help', 'check']),
  ]);
  expect([short, long]).toEqual(Array(2).fill({ code: 0, signal: null, stdout: `${version}\n`, stderr: '' }));
  for (const name of names) expect(root.stdout).toContain(`\n  ${name} `);
  for (const help of [root, ...helps]) {
    expect(help).toMatchObject({ code: 0, stderr: '' });
    expect(help.stdout).toContain('Examples:\n  $ gq ');
  }
  expect(helps.at(-1)).toEqual(helps[0]);
});

it('lists its commands without what reads files and levels', async () => {
  const loaded = [...(await gqCovered(['--help'], cwd)).loaded];
  expect(loaded).toContain('cli/command-line.js');
  expect(loaded.filter((name) => /^(?:cli\/io|engine|schema\/json)\/|^zod$/.test(name))).toEqual([]);
});

itDeep('prints the same output with any number of workers', async () => {
  const args = ['check', 'many', '--format', 'json', '--jobs'];
  const ended = await Promise.all([gq([...args, '1'], { cwd }), gqProcess([...args, '2'], { cwd })]);
  const reports = ended.map(({ stdout }) => withoutTimes(stdout));
  expect(new Set(reports).size).toBe(1);
  const names = JSON.parse(reports[0]).levels.map((level: { name: string }) => level.name);
  expect(names).toEqual(
    Array.from({ length: 130 }, (_, i) => `Level ${i}`).sort((a, b) => (`${a.slice(6)}.` < `${b.slice(6)}.` ? -1 : 1)),
  );
  expect(ended.map(({ code }) => code)).toEqual([0, 0]);
});

describeQuick('a reader that closes the pipe', () => {
  it('ends gq quietly, with the exit code of the check', () => {
    const pipe = (command: string) =>
      execFileSync('bash', ['-c', `${command} 2>err; echo "\${PIPESTATUS[0]}"; cat err`, '--', process.execPath, MAIN], {
        cwd,
        encoding: 'utf8',
      });
    expect(pipe('"$1" "$2" check many --jobs 1 | head -1').split('\n').slice(1)).toEqual(['0', '']);
    expect(pipe('"$1" "$2" simulate good.level.json --sample 10000 --format json | head -c 5')).toBe('{"ver0\n');
    expect(pipe('"$1" "$2" --version | true')).toBe('0\n');
  });
});

it('writes a large report completely to a slow pipe', async () => {
  const { code, stdout } = await gqProcess(
    ['simulate', 'good.level.json', '--accuracy', 'arcade', '--sample', '10000', '--format', 'json'],
    {
      cwd,
      env: interruptAt({ of: 'output', number: 1, say: 'the report begins' }),
      during: (child) => {
        // reads one piece in each turn of the loop, and none before the report begins
        child.stdout?.pause();
        child.stderr?.once('data', () => child.stdout?.resume());
        child.stdout?.on('data', () => {
          child.stdout?.pause();
          setImmediate(() => child.stdout?.resume());
        });
      },
    },
  );
  expect(code).toBe(0);
  const report = JSON.parse(stdout);
  expect(report.samples.length).toBeGreaterThan(10_000);
  expect(report.samples.at(-1)[0]).toBeLessThanOrEqual(report.time);
});

it.runIf(process.platform === 'linux')('reports a full disk behind stdout, with exit code 2, also for a report in pieces', () => {
  const script = `cat good.level.json | tr -d '\\n' >one.ndjson; "$1" "$2" check one.ndjson --format json 2>&1 >/dev/full; echo $?`;
  const pieces = execFileSync('bash', ['-c', script, '--', process.execPath, MAIN], { cwd, encoding: 'utf8' });
  expect(pieces).toMatch(/^error: can't write to standard output: .*ENOSPC.*\n2\n$/);
  const text = execFileSync(
    'bash',
    ['-c', '"$1" "$2" check good.level.json 2>&1 >/dev/full; echo $?', '--', process.execPath, MAIN],
    {
      cwd,
      encoding: 'utf8',
    },
  );
  expect(text).toMatch(/^error: can't write to standard output: .*ENOSPC.*\n2\n$/);
});

describe.runIf(process.platform === 'linux')('a signal', () => {
  itDeep('ends gq and its workers with 130 or 143, and nothing is written', async () => {
    const args = ['check', 'long', '--format', 'json', '--accuracy', 'arcade', '--max-time', '3600'];
    const [int, term] = await Promise.all([
      gqProcess([...args, '--jobs', '1'], { cwd, env: interruptAt({ of: 'online', number: 1, signals: ['SIGINT'] }) }),
      gqProcess([...args, '--jobs', '2'], { cwd, env: interruptAt({ of: 'online', number: 2, signals: ['SIGTERM'] }) }),
    ]);
    expect(int).toEqual({ code: 130, signal: null, stdout: '', stderr: '' });
    expect(term).toEqual({ code: 143, signal: null, stdout: '', stderr: '' });
  });

  it('ends gq at once while it waits for a pipe, or for the reader of its report', async () => {
    execFileSync('mkfifo', [join(cwd, 'pipe')]);
    // opened for reading and writing, so that opening does not wait for the other end
    const pipe = openSync(join(cwd, 'pipe'), constants.O_RDWR);
    const noSamples = ['simulate', 'good.level.json', '--sample', '10000', '--format', 'json'];
    for (const [args, stdio, of] of [
      [['check', '/dev/stdin'], [pipe, 'ignore', 'pipe'], 'readSync'],
      [noSamples, ['ignore', pipe, 'pipe'], 'output'],
    ] as const) {
      const env = { ...process.env, ...interruptAt({ of, number: 1, say: 'waits' }) };
      const child = spawn(process.execPath, [MAIN, ...args], { cwd, env, stdio: [...stdio] });
      const ended = new Promise((resolve) => child.on('close', (code, signal) => resolve([code, signal])));
      // right before gq waits: a handler would be called only after the wait, which never ends
      child.stderr?.once('data', () => child.kill('SIGINT'));
      expect(await ended).toEqual([null, 'SIGINT']);
    }
    closeSync(pipe);
  });
});

describeQuick('colours', () => {
  it('are not used in pipes and with NO_COLOR, and are always used with FORCE_COLOR', async () => {
    const env = { NO_COLOR: '', CI: 'true' };
    const [piped, forced, none] = await Promise.all([
      gqProcess(['check', 'good.level.json'], { cwd, env }),
      gqProcess(['check', 'good.level.json'], { cwd, env: { ...env, FORCE_COLOR: '1' } }),
      gqProcess(['check', 'good.level.json'], { cwd, env: { FORCE_COLOR: '1', NO_COLOR: '1' } }),
    ]);
    expect(piped.stdout).not.toContain('\u001b');
    expect(forced.stdout).toContain('\u001b[32mcompletable');
    expect(none.stdout).toBe(piped.stdout);
  });

  it('in the text of a level never reach the terminal', async () => {
    writeFileSync(
      join(cwd, 'evil.level.json'),
      fallThrough({ name: 'red \u001b[31m \u009b\u202e', runs: [{ name: '\u001b]0;title\u0007', holds: [] }] }),
    );
    writeFileSync(join(cwd, 'worse.level.json'), '{"\u001b[2J": 1}');
    const ended = await Promise.all([
      gq(['check', 'evil.level.json', 'worse.level.json'], { cwd }),
      gq(['simulate', 'evil.level.json'], { cwd }),
      gq(['inspect', 'worse.level.json'], { cwd }),
      gq(['simulate', 'evil.level.json', '--run', '\u001b[1m'], { cwd }),
      gq(['check', '\u001b[1m'], { cwd }),
    ]);
    // except newlines
    for (const { stdout, stderr } of ended) expect((stdout + stderr).replaceAll('\n', '')).not.toMatch(/[\p{Cc}\u202e]/u);
    expect(ended[0].stdout).toContain('red \\u001b[31m');
  });
});

describeQuick('the files of a directory', () => {
  it('are read once: links are followed, loops and hidden files left out; a broken link is exit code 2, and the rest is checked', async () => {
    const root = join(cwd, 'tree');
    for (const name of ['sub/deep', '.git', 'node_modules/x', 'named.level.json'])
      mkdirSync(join(root, name), { recursive: true });
    for (const name of ['z', 'sub/deep/b', '.git/hidden', 'node_modules/x/foreign', 'named.level.json/inside']) {
      writeFileSync(join(root, `${name}.level.json`), fallThrough());
    }
    symlinkSync('..', join(root, 'sub/up'));
    symlinkSync('round.level.json', join(root, 'round.level.json'));
    symlinkSync('z.level.json', join(root, 'link.level.json'));
    const { code, stdout } = await gq(['check', 'tree', './tree/z.level.json', '--format', 'json'], { cwd });
    expect(code).toBe(2);
    const { levels, summary } = JSON.parse(stdout);
    expect(levels.map((l: { file: string; verdict: string }) => [l.file, l.verdict])).toEqual([
      ['tree/link.level.json', 'completable'],
      ['tree/named.level.json/inside.level.json', 'completable'],
      ['tree/round.level.json', 'invalid'],
      ['tree/sub/deep/b.level.json', 'completable'],
      ['tree/z.level.json', 'completable'],
    ]);
    expect(levels[2].problems[0]).toMatchObject({ code: 'unreadable-file', line: null, column: null, pointer: '' });
    expect(summary).toEqual({ completable: 4, broken: 0, unproven: 0, impossible: 0, invalid: 1, crashed: 0 });
  });

  it('can also be selected by patterns', async () => {
    const files = async (pattern: string) => (await findLevelFiles([`${cwd}/${pattern}`])).files;
    expect(await files('many/1?.level.json')).toEqual(Array.from({ length: 10 }, (_, i) => `${cwd}/many/1${i}.level.json`));
    expect(await files('**/b*.json')).toEqual([`${cwd}/tree/sub/deep/b.level.json`]);
    const { stdout } = await gq(['check', '--format', 'json', 'good.*', 'many/12?.level.json'], { cwd });
    const named = JSON.parse(stdout).levels.map((level: { file: string }) => level.file);
    expect(named).toEqual(['good.level.json', ...Array.from({ length: 10 }, (_, i) => `many/12${i}.level.json`)]);
  });
});
