import { EventEmitter } from 'node:events';
import { mkdirSync, rmSync } from 'node:fs';
import { basename, join } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { KnownLevels } from '../../cli/serve/known-levels.ts';
import { watchFolder } from '../../cli/serve/watch.ts';
import { makeFolder } from './running.ts';

// How events of the system are handled; events.test.ts tests that the system sends them.

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
/** What is reported within `ms`, in which the watcher reads the folder. */
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

describe.runIf(process.platform === 'linux')('a watched folder', () => {
  it('is read completely at the start, and later only the changed levels are, together', async () => {
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

  it('is read completely when a folder may have appeared or vanished, but not for hidden ones', async () => {
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

  it('has each of its folders watched once, also when folders appear and vanish', async () => {
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
    // a new folder of the same name, made while the old one still exists, so that its inode differs
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

  it('is reported if it can not be watched, and the other folders are watched', async () => {
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

  it('is released at the end, and nothing more is reported', async () => {
    await start();
    of('').tell('a.level.json');
    stop();
    expect([await look(1000), open(), vi.getTimerCount()]).toEqual([[], [], 0]);
    // during a read
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
