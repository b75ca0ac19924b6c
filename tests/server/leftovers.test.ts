import { execFileSync } from 'node:child_process';
import {
  chmodSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  symlinkSync,
  utimesSync,
  writeFileSync,
} from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, expect } from 'vitest';
import { openLevelFolder } from '../../cli/serve/level-folder.ts';
import { collectLeftovers } from '../../cli/serve/trash.ts';
import { describeQuick, itQuick as it, itDeep } from '../depth.ts';
import { gqEdit } from './command.ts';
import { everythingIn, levelText, makeFolder, put } from './running.ts';

let made: ReturnType<typeof makeFolder>;
beforeEach(() => {
  made = makeFolder({ 'a.level.json': levelText('a') });
});
afterEach(() => made.remove());

const write = (): Promise<{ entry: { name: string | null } }> => {
  const levels = openLevelFolder(made.folder, 'levels');
  return levels.write('a', levelText('new'), { etag: levels.read('a').etag ?? '' }, 'c').finally(levels.end);
};
const lock = (): string => join(made.folder, '.gq-edit.lock');

describeQuick.runIf(process.platform === 'linux')('an obstacle in place of the lock', () => {
  it.each([
    ['a device without end', () => symlinkSync('/dev/zero', lock())],
    ['a link to nowhere', () => symlinkSync('nowhere', lock())],
    ['a link to a level', () => symlinkSync('a.level.json', lock())],
    ['a pipe', () => void execFileSync('mkfifo', [lock()])],
    ['an empty folder', () => mkdirSync(lock())],
    [
      'an empty file from a time to come',
      () => {
        writeFileSync(lock(), '');
        utimesSync(lock(), 4e9, 4e9);
      },
    ],
  ])('%s does not make anybody wait', async (_, stand) => {
    stand();
    expect((await write()).entry.name).toBe('new');
    expect(readdirSync(made.folder)).toEqual(['a.level.json']);
  });

  it('a folder that is not empty stays, and is named', async () => {
    mkdirSync(lock());
    writeFileSync(join(lock(), 'work'), '');
    await expect(write()).rejects.toMatchObject({
      code: 'not-writable',
      message: expect.stringContaining('.gq-edit.lock is in the way'),
    });
    expect(everythingIn(made.folder)).toMatchObject({ 'a.level.json': levelText('a'), '.gq-edit.lock/work': '' });
  });
});

it.runIf(process.platform !== 'win32')('a read-only level is not overwritten, even by root', async () => {
  chmodSync(join(made.folder, 'a.level.json'), 0o444);
  await expect(write()).rejects.toMatchObject({ code: 'not-writable' });
  expect(readFileSync(join(made.folder, 'a.level.json'), 'utf8')).toBe(levelText('a'));
});

it('leftovers of killed processes are cleaned up once no process can still be using them', () => {
  const [work, empty, inTrash] = ['0123456789abcdef', '00112233445566aa', '00112233445566bb'].map((hex) => `.gq-edit-${hex}.tmp`);
  put(made.folder, work, levelText('work'));
  put(made.folder, empty, '');
  put(made.folder, `.gq-trash/${inTrash}`, '*');
  put(made.folder, '.gq-edit.lock.0123456789abcdef', '1 host x');
  put(made.folder, '.gq-edit.lock.txt', 'mine');
  const before = everythingIn(made.folder);
  const now = Date.now();
  collectLeftovers(made.folder, [''], new Date(now), 60_000);
  expect(everythingIn(made.folder)).toEqual(before);
  collectLeftovers(made.folder, [''], new Date(now + 120_000), 60_000);
  const after = everythingIn(made.folder);
  for (const name of [work, empty, `.gq-trash/${inTrash}`, '.gq-edit.lock.0123456789abcdef'])
    expect(after).not.toHaveProperty([name]);
  expect(after['.gq-edit.lock.txt']).toBe('mine');
  const kept = Object.keys(after).filter((name) => name.endsWith('unfinished-0123456789abcdef.level.json'));
  expect(kept.map((name) => after[name])).toEqual([levelText('work')]);
});

it('leftovers from the future count as old, too, and go to the trash together', () => {
  const now = Date.now();
  const unfinished = ['0123456789abcdef', '00112233445566aa'].map((hex) => `.gq-edit-${hex}.tmp`);
  for (const [i, name] of unfinished.entries()) {
    put(made.folder, name, levelText(`${i}`));
    utimesSync(join(made.folder, name), now / 1000 + 3600, now / 1000 + 3600);
  }
  put(made.folder, 'sub/.gq-edit-0123456789abcdee.tmp', levelText('young'));
  put(made.folder, 'sub/.gq-edit.lock.0123456789abcdef', 'of no use here');
  collectLeftovers(made.folder, ['', 'sub'], new Date(now), 60_000);
  const names = Object.keys(everythingIn(made.folder)).sort();
  const stamps = names.filter((name) => /^\.gq-trash\/[^/]*Z$/.test(name));
  expect(stamps).toHaveLength(1);
  expect(names.filter((name) => name.startsWith(`${stamps[0]}/`))).toEqual(
    ['00112233445566aa', '0123456789abcdef'].map((hex) => `${stamps[0]}/unfinished-${hex}.level.json`),
  );
  expect(names.filter((name) => name.startsWith('sub/'))).toEqual([
    'sub/.gq-edit-0123456789abcdee.tmp',
    'sub/.gq-edit.lock.0123456789abcdef',
  ]);
});

itDeep('a folder keeps its port; if that is taken, gq edit says where unsaved edits are', async () => {
  const env = { XDG_STATE_HOME: mkdtempSync(join(tmpdir(), 'gq-state-')) };
  const start = (...args: string[]) => gqEdit(['.', ...args], { cwd: made.folder, env });
  const any = await start('--port', '0');
  await any.end('SIGTERM');
  const again = await start('--port', '0');
  expect(again.port).toBe(any.port);
  await again.end('SIGTERM');
  const first = await start('--port', String(any.port));
  await first.end('SIGTERM');
  const second = await start();
  expect(second.port).toBe(first.port);
  expect(second.said().stdout).toMatch(/^Editing/);
  await second.end('SIGTERM');

  const taken = createServer().listen(first.port, '127.0.0.1');
  const third = await start();
  expect(third.port).not.toBe(first.port);
  const said = `Port ${first.port} is taken, perhaps by another gq edit; this one uses ${third.port}. If a page could not save its changes last time`;
  expect(third.said().stdout).toContain(said);
  expect(third.said().stdout).toContain(`http://127.0.0.1:${first.port}/: gq edit --port ${first.port} finds them`);
  await third.end('SIGTERM');
  await new Promise((resolve) => taken.close(resolve));
  // the old port was not forgotten
  const fourth = await start();
  expect(fourth.port).toBe(first.port);
  await fourth.end('SIGTERM');
  expect(existsSync(env.XDG_STATE_HOME)).toBe(true);
});
