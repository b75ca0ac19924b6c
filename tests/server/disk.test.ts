import { readdirSync, readFileSync, utimesSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { createFile, replaceFile } from '../../cli/io/disk.ts';
import { openLevelFolder } from '../../cli/serve/level-folder.ts';
import { oneAtATime } from '../../cli/serve/one-at-a-time.ts';
import { levelText, makeFolder } from './running.ts';

// The steps on the disk, their order, and what another process does in between.

const disk = vi.hoisted(() => ({ steps: [] as string[], before: null as null | ((step: string, path: string) => void) }));

vi.mock('node:fs', async (original) => {
  const fs = await original<typeof import('node:fs')>();
  const watched = (name: 'writeFileSync' | 'fsyncSync' | 'linkSync' | 'renameSync') => {
    const real = fs[name] as (...args: unknown[]) => unknown;
    return (...args: unknown[]): unknown => {
      const hook = disk.before;
      // steps of the hook itself are not recorded
      disk.before = null;
      hook?.(name, String(args[0]));
      disk.before = hook;
      disk.steps.push(name);
      return real(...args);
    };
  };
  const names = ['writeFileSync', 'fsyncSync', 'linkSync', 'renameSync'] as const;
  return { ...fs, ...Object.fromEntries(names.map((name) => [name, watched(name)])) };
});

// waiting for a lock takes no time, and a hook may act for another process in the meantime
vi.mock('node:timers/promises', async (original) => ({
  ...(await original<typeof import('node:timers/promises')>()),
  setTimeout: async () => disk.before?.('wait', ''),
}));

let made: ReturnType<typeof makeFolder>;
beforeEach(() => {
  made = makeFolder({ '01.level.json': levelText('A') });
  disk.steps = [];
});
afterEach(() => {
  disk.before = null;
  made.remove();
});

describe('a content is synced to the disk before it gets its name', () => {
  it('if it replaces another, and the folder is synced after that', () => {
    replaceFile(join(made.folder, '01.level.json'), Buffer.from('new'), () => {});
    const [write, sync, rename, ...rest] = disk.steps;
    expect([write, sync, rename]).toEqual(['writeFileSync', 'fsyncSync', 'renameSync']);
    if (process.platform !== 'win32') expect(rest).toEqual(['fsyncSync']);
  });

  it('if it is new', () => {
    expect(createFile(join(made.folder, '02.level.json'), Buffer.from('new'))).toBe(true);
    expect(disk.steps.slice(0, 3)).toEqual(['writeFileSync', 'fsyncSync', 'linkSync']);
  });
});

describe('changes by others at the last moment', () => {
  it('a level that another program writes during a write is not overwritten', async () => {
    const path = join(made.folder, '01.level.json');
    const levels = openLevelFolder(made.folder, 'levels');
    const etag = levels.read('01').etag ?? '';
    let done = false;
    disk.before = (step) => {
      if (step !== 'fsyncSync' || done) return;
      done = true;
      writeFileSync(path, levelText('theirs'));
    };
    await expect(levels.write('01', levelText('mine'), { etag }, 'page')).rejects.toThrow();
    expect(done).toBe(true);
    expect(readFileSync(path, 'utf8')).toBe(levelText('theirs'));
  });

  it('a lock that another process takes between reading a stale one and removing it is put back', async () => {
    const lock = join(made.folder, '.gq-edit.lock');
    // of a process that has ended
    writeFileSync(lock, '999999999 nowhere 0123456789abcdef');
    utimesSync(lock, new Date(0), new Date(0));
    let stolen = false;
    let kept = '';
    disk.before = (step, path) => {
      if (step === 'renameSync' && path === lock && !stolen) {
        stolen = true;
        writeFileSync(lock, 'theirs');
      } else if (step === 'wait' && kept === '') {
        kept = readFileSync(lock, 'utf8');
        // and the other process is done
        utimesSync(lock, new Date(0), new Date(0));
      }
    };
    await oneAtATime(made.folder, () => undefined);
    expect(stolen).toBe(true);
    expect(kept).toBe('theirs');
    expect(readdirSync(made.folder)).toEqual(['01.level.json']);
  });
});
