import { EventEmitter } from 'node:events';
import { mkdirSync, rmSync } from 'node:fs';
import { basename, join } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { KnownLevels } from '../../cli/edit/known-levels.ts';
import { watchFolder } from '../../cli/edit/watch.ts';
import { makeFolder } from './running.ts';

// What is made of what the system tells of a folder; that it tells it, the tests of events say.

interface Watcher extends EventEmitter {
  readonly path: string;
  readonly options: unknown;
  readonly tell: (name: string | null) => void;
  isClosed: boolean;
  close(): void;
}
const system = vi.hoisted(() => ({ watchers: [] as unknown[], refuses: null as string | null }));
vi.mock('node:fs', async (original) => ({
  ...(await original<typeof import('node:fs')>()),
  watch(path: string, options: unknown, listener: (type: string, name: string | null) => void) {
    if (system.refuses === path) throw Object.assign(new Error('ENOSPC: no more watches'), { code: 'ENOSPC' });
    const watcher: Watcher = Object.assign(new EventEmitter(), {
      ...{ path, options, isClosed: false, tell: (name: string | null) => listener('rename', name) },
      close() {
        watcher.isClosed = true;
      },
    });
    system.watchers.push(watcher);
    return watcher;
  },
}));

let made: ReturnType<typeof makeFolder>;
let folders: string[];
let said: string[];
let known: KnownLevels;
let stop: () => void;
beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
  made = makeFolder({});
  folders = [''];
  said = [];
  system.watchers = [];
  system.refuses = null;
  known = {
    list: () => ({ folders }),
    announce: (ids: string[], by: string | null) => said.push(`announce ${ids} by ${by}`),
    refresh: async () => said.push('refresh'),
    addTrouble: (message: string) => said.push(message),
  } as unknown as KnownLevels;
});
afterEach(() => {
  stop();
  vi.useRealTimers();
  made.remove();
});

const path = (folder: string) => (folder === '' ? made.folder : join(made.folder, folder));
const open = () => (system.watchers as Watcher[]).filter(({ isClosed }) => !isClosed);
const of = (folder: string) => open().find((watcher) => watcher.path === path(folder)) as Watcher;
/** What is said by the time that it is looked. */
async function look(ms = 60): Promise<string[]> {
  await vi.advanceTimersByTimeAsync(ms);
  return said.splice(0);
}
async function start(): Promise<void> {
  stop = watchFolder(made.folder, known);
  expect(await look(59)).toEqual([]);
  expect(await look(1)).toEqual(['refresh']);
  expect(vi.getTimerCount()).toBe(0);
}

describe.runIf(process.platform === 'linux')('a folder that is watched', () => {
  it('is looked at once at the start, and then only at the levels that were touched, together', async () => {
    await start();
    of('').tell('a.level.json');
    expect(await look(30)).toEqual([]);
    of('').tell('b.level.json');
    of('').tell('a.level.json');
    expect(await look(29)).toEqual([]);
    expect(await look(1)).toEqual(['announce a,b by null']);
    expect(await look(1000)).toEqual([]);
    of('').tell('a.level.json');
    expect(await look()).toEqual(['announce a by null']);
  });

  it('is looked at as a whole when a folder may have come or gone, and not for what is hidden', async () => {
    mkdirSync(path('w'));
    folders.push('w');
    await start();
    for (const name of ['.git', '.gq-edit.lock', 'node_modules']) {
      of('').tell(name);
      of('w').tell(name);
    }
    expect([await look(1000), vi.getTimerCount()]).toEqual([[], 0]);
    of('w').tell('c.level.json');
    expect(await look()).toEqual(['announce w/c by null']);
    for (const tell of [
      () => of('').tell('new'),
      () => of('').tell(null),
      () => of('w').tell('x.txt'),
      () => of('').tell(basename(made.folder)),
    ]) {
      tell();
      of('').tell('a.level.json');
      expect(await look()).toEqual(['refresh']);
      of('').tell('b.level.json');
      expect(await look()).toEqual(['announce b by null']);
    }
  });

  it('has all its folders watched as they come and go, each once', async () => {
    mkdirSync(path('w'));
    folders.push('w');
    await start();
    expect(open().map((watcher) => [watcher.path, watcher.options])).toEqual([
      [path(''), { persistent: false, recursive: false }],
      [path('w'), { persistent: false, recursive: false }],
    ]);
    const [root, before] = [of(''), of('w')];
    mkdirSync(path('v'));
    folders = ['', 'v', 'w'];
    of('').tell('v');
    await look();
    expect(
      open()
        .map((watcher) => watcher.path)
        .sort(),
    ).toEqual(['', 'v', 'w'].map(path).sort());
    expect([of(''), of('w')]).toEqual([root, before]);
    // another folder of the same name is another folder: made while the old one is there, so that it has another number
    mkdirSync(path('next'));
    rmSync(path('w'), { recursive: true });
    mkdirSync(path('w'));
    mkdirSync(path('last'));
    folders = ['', 'w'];
    of('').tell('w');
    await look();
    expect(
      open()
        .map((watcher) => watcher.path)
        .sort(),
    ).toEqual(['', 'w'].map(path).sort());
    rmSync(path('w'), { recursive: true });
    of('').tell('w');
    await look();
    expect(open().map((watcher) => watcher.path)).toEqual([path('')]);
  });

  it('that can not be watched is a trouble that is told, and the others are watched', async () => {
    for (const name of ['v', 'w']) mkdirSync(path(name));
    folders.push('v', 'w');
    system.refuses = path('v');
    stop = watchFolder(made.folder, known);
    const trouble = expect.stringMatching(/^changes by other programs may be seen late: the folder can't be watched: /);
    expect(await look()).toEqual([trouble, 'refresh', trouble]);
    expect(open().map((watcher) => watcher.path)).toEqual(['', 'w'].map(path));
    of('').emit('error', new Error('gone'));
    expect(await look()).toEqual([trouble]);
    known.refresh = () => Promise.reject(new Error('failed'));
    of('').tell('x');
    expect(await look()).toEqual([trouble]);
  });

  it('is let go of, and nothing more is said', async () => {
    await start();
    of('').tell('a.level.json');
    stop();
    expect([await look(1000), open(), vi.getTimerCount()]).toEqual([[], [], 0]);
    // while it is looked at
    let go = () => {};
    known.refresh = () =>
      new Promise((resolve) => {
        go = () => resolve(known.list());
      });
    stop = watchFolder(made.folder, known);
    await look();
    mkdirSync(path('w'));
    folders.push('w');
    stop();
    go();
    await look(1000);
    expect(open()).toEqual([]);
  });
});
