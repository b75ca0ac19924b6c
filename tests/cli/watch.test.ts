import { type ChildProcess, spawn } from 'node:child_process';
import { mkdirSync, renameSync, rmSync, utimesSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { afterEach, expect, it } from 'vitest';
import type { CommandResult } from '../../cli/command.ts';
import { leaveSignals } from '../../cli/terminal/signals.ts';
import { watchAndRepeat, watchedPaths } from '../../cli/watch/index.ts';
import { fallThrough, gq, MAIN, makeFiles } from './gq.ts';

let files = makeFiles({});
let child: ChildProcess | null = null;
afterEach(() => {
  child?.kill('SIGKILL');
  files.remove();
});

const write = (path: string, text: string): void => writeFileSync(join(files.directory, path), text);

/** A gq that watches, with what it has printed so far. */
class Watching {
  out = '';
  err = '';
  private wake: () => void = () => {};
  readonly ended: Promise<number | null>;

  constructor(args: readonly string[], command = process.execPath, before: readonly string[] = [MAIN]) {
    const started = spawn(command, [...before, ...args], {
      cwd: files.directory,
      env: { ...process.env, NO_COLOR: '1', GITHUB_STEP_SUMMARY: '' },
    });
    child = started;
    started.stdout.on('data', (data) => {
      this.out += data;
      this.wake();
    });
    started.stderr.on('data', (data) => {
      this.err += data;
      this.wake();
    });
    this.ended = new Promise((done) => void started.on('close', done));
  }

  async until(isThere: () => boolean): Promise<void> {
    while (!isThere())
      await new Promise<void>((done) => {
        this.wake = done;
      });
  }

  /** The levels of every round so far. */
  rounds(): Level[][] {
    const lines = this.out.split('\n').slice(0, -1);
    return lines.map((line) => JSON.parse(line).levels);
  }

  /** Waits until the last round is this, in words. A slow machine may see a change in two steps, and so in two rounds. */
  async untilRound(expected: readonly string[], inWords: (level: Level) => string = ({ name, verdict }) => `${name} ${verdict}`) {
    const isThere = (): boolean => JSON.stringify(this.rounds().at(-1)?.map(inWords)) === JSON.stringify(expected);
    await this.until(isThere);
  }
}

interface Level {
  readonly name: string;
  readonly verdict: string;
  readonly problems: readonly { readonly code: string }[];
}

const begin = (): void => {
  files = makeFiles(Object.fromEntries(['a', 'b', 'sub/c'].map((name) => [`levels/${name}.level.json`, fallThrough({ name })])));
};

it('gq check --watch checks what is changed, added, deleted, renamed and made again', async () => {
  begin();
  const watching = new Watching(['check', '--watch', '--format', 'json']);
  await watching.untilRound(['a completable', 'b completable', 'sub/c completable']);
  // as an editor that writes beside the file and renames
  write('levels/.a.tmp', fallThrough({ name: 'A', runs: [] }));
  renameSync(join(files.directory, 'levels/.a.tmp'), join(files.directory, 'levels/a.level.json'));
  await watching.untilRound(['A unproven', 'b completable', 'sub/c completable']);
  write('levels/a.level.json', '{');
  await watching.untilRound(['a invalid', 'b completable', 'sub/c completable']);
  rmSync(join(files.directory, 'levels/a.level.json'));
  await watching.untilRound(['b completable', 'sub/c completable']);
  renameSync(join(files.directory, 'levels/b.level.json'), join(files.directory, 'levels/z.level.json'));
  await watching.untilRound(['sub/c completable', 'b completable']);
  rmSync(join(files.directory, 'levels'), { recursive: true });
  await watching.until(() => watching.err.includes('error: nothing was done: a path matches no level file'));
  mkdirSync(join(files.directory, 'levels/new'), { recursive: true });
  write('levels/new/d.level.json', fallThrough({ name: 'd' }));
  await watching.untilRound(['d completable']);
  write('levels/new/d.level.json', fallThrough({ name: 'e' }));
  await watching.untilRound(['e completable']);
  child?.kill('SIGINT');
  expect(await watching.ended).toBe(130);
});

it('gq check --watch makes few rounds of a burst, and checks all again for the configuration and the lock', async () => {
  begin();
  await gq(['check', '--update-lock'], { cwd: files.directory });
  const watching = new Watching(['check', '--watch', '--format', 'json', '--lock', 'gq.lock.json']);
  const untilCodes = (code: string) =>
    watching.untilRound(Array(3).fill(code), ({ problems }) => problems.map((problem) => problem.code).join());
  await untilCodes('');
  write('gq.config.json', '{ "rules": { "pull": 45 } }');
  await untilCodes('result-changed');
  const before = watching.rounds().length;
  write('gq.config.json', '{ "rules": { "pull": "x" } }');
  await watching.until(() => watching.err.includes('the configuration is not valid'));
  write('gq.config.json', '{ "rules": { "pull": 45 } }');
  // all is as before the error, and said again
  await watching.until(() => watching.rounds().length > before);
  await untilCodes('result-changed');
  await gq(['check', '--update-lock'], { cwd: files.directory });
  await untilCodes('');
  const rounds = watching.rounds().length;
  // neither of this changes a report
  write('levels/notes.txt', 'x');
  utimesSync(join(files.directory, 'gq.lock.json'), new Date(), new Date());
  const names = Array.from({ length: 40 }, (_, i) => `n${i + 10}`);
  for (const name of names) write(`levels/${name}.level.json`, fallThrough({ name }));
  await watching.untilRound(['a', 'b', ...names, 'sub/c'], ({ name }) => name);
  expect(watching.rounds().length - rounds).toBeLessThan(10);
  child?.kill('SIGTERM');
  expect(await watching.ended).toBe(143);
});

it('gq check --watch follows the configuration that --config names', async () => {
  begin();
  mkdirSync(join(files.directory, 'conf'));
  write('conf/strict.json', '{ "levels": "../levels/a.level.json" }');
  const watching = new Watching(['check', '--watch', '--format', 'json', '--config', 'conf/strict.json']);
  await watching.untilRound(['a completable']);
  write('conf/strict.json', '{ "levels": "../levels/a.level.json", "rules": { "pull": 10 } }');
  // a round with the same reports says nothing
  await watching.until(() => watching.rounds().length > 1);
});

it('gq check --watch lists what has changed, with the summary of all', async () => {
  begin();
  const watching = new Watching(['check', '-w']);
  await watching.until(() => watching.out.includes('3 levels: 3 completable'));
  expect(watching.out).toContain('levels/a.level.json');
  watching.out = '';
  write('levels/b.level.json', fallThrough({ name: 'B', runs: [] }));
  await watching.until(() => watching.out.includes('explain CODE'));
  expect(watching.out).toContain('3 levels: 2 completable, 1 unproven');
  expect(watching.out).toContain('unproven     levels/b.level.json');
  expect(watching.out).not.toMatch(/levels\/(a|sub\/c)\.level/);
  expect(watching.out).not.toContain('\u001b');
});

it('gq check --watch ends when a signal has ended the check of a round', async () => {
  begin();
  let rounds = 0;
  const round = async (): Promise<CommandResult> => ({ exitCode: rounds++ === 0 ? 130 : 0 });
  const ended = await watchAndRepeat({ paths: [files.directory], files: [], round, forget: () => {} });
  await leaveSignals();
  expect([ended, rounds]).toEqual([{ exitCode: 130 }, 1]);
});

it('--watch does not go with what is done once, and ends at once when there is nothing to check', async () => {
  begin();
  const { directory: cwd } = files;
  for (const [args, message] of [
    [['--update-lock'], /expected no --watch/],
    [['-'], /expected no level from standard input/],
    [['nowhere'], /nothing was done: a path matches no level file/],
    [['--budget', '3'], /give --solve as well/],
  ] as const)
    expect(await gq(['check', '--watch', ...args], { cwd })).toMatchObject({ code: 2, stderr: expect.stringMatching(message) });
});

it.runIf(process.platform === 'linux')('on a terminal, the key q ends it and a checks all again', async () => {
  begin();
  const watching = new Watching(['-qec', `"${process.execPath}" "${MAIN}" check -w`, '/dev/null'], 'script', []);
  const prompt = 'watching for changes: a checks all again, q ends';
  await watching.until(() => watching.out.includes(prompt));
  child?.stdin?.write('a');
  await watching.until(() => watching.out.split(prompt).length === 3);
  expect(watching.out.split('levels/sub/c.level.json')).toHaveLength(3);
  child?.stdin?.write('q');
  expect(await watching.ended).toBe(0);
});

it('watches the folders around what may vanish, and nothing that does not matter', () => {
  begin();
  const at = (path: string): string => resolve(files.directory, path);
  const { roots, matters } = watchedPaths([at('levels'), at('one/x.level.json'), at('drafts/*.json')], [at('out/gq.lock.json')]);
  expect(roots).toContain(files.directory);
  const paths = ['levels', 'levels/a.level.json', 'levels/x/y', 'one', 'one/x.level.json', 'drafts/z.json', 'out/gq.lock.json'];
  expect(paths.filter((path) => !matters(at(path)))).toEqual([]);
  const others = ['node_modules', 'levels/.git/x', 'levels/node_modules/x', 'one/y.level.json', 'out/other', 'levels2'];
  expect(others.filter((path) => matters(at(path)))).toEqual([]);
});
