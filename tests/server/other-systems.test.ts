import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, symlinkSync, unlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { createFile, isTaken, moveFile, replaceFile, tryFolder, UNFINISHED } from '../../cli/io/disk.ts';
import { makeFolder } from './running.ts';

// Disks and systems other than the one of the tests: without links, ignoring case, with scanners that lock files.

type Step =
  | 'closeSync'
  | 'linkSync'
  | 'renameSync'
  | 'rmSync'
  | 'lstatSync'
  | 'openSync'
  | 'fsyncSync'
  | 'fchmodSync'
  | 'fchownSync';
type Call = readonly [step: Step, ...args: unknown[]];

const disk = vi.hoisted(() => ({
  calls: [] as unknown[],
  /** Replaces a step; undefined: the step is done as usual. */
  instead: (() => undefined) as (call: Call) => undefined | { readonly value: unknown },
}));

vi.mock('node:fs', async (original) => {
  const fs = await original<typeof import('node:fs')>();
  const names: Step[] = [
    'closeSync',
    'linkSync',
    'renameSync',
    'rmSync',
    'lstatSync',
    'openSync',
    'fsyncSync',
    'fchmodSync',
    'fchownSync',
  ];
  const watched = (name: Step) => {
    const real = fs[name] as (...args: unknown[]) => unknown;
    return (...args: unknown[]): unknown => {
      disk.calls.push([name, ...args]);
      const instead = disk.instead([name, ...args]);
      return instead === undefined ? real(...args) : instead.value;
    };
  };
  return { ...fs, ...Object.fromEntries(names.map((name) => [name, watched(name)])) };
});

const fails = (code: string): never => {
  throw Object.assign(new Error(code), { code });
};
const calls = () => disk.calls as Call[];
const count = (step: Step) => calls().filter(([name]) => name === step).length;
const { platform, getuid, getgid } = process;

let made: ReturnType<typeof makeFolder>;
let path: (name: string) => string;
beforeEach(() => {
  made = makeFolder({ a: 'A', b: 'B' });
  mkdirSync(join(made.folder, 'sub'));
  path = (name) => join(made.folder, name);
  disk.calls = [];
});
afterEach(() => {
  disk.instead = () => undefined;
  Object.defineProperty(process, 'platform', { value: platform });
  Object.assign(process, { getuid, getgid });
  made.remove();
});
const content = (name: string) => (existsSync(path(name)) ? readFileSync(path(name), 'utf8') : null);
const names = () => readdirSync(made.folder).sort();

describe('a disk without links', () => {
  it.each(['EPERM', 'ENOTSUP', 'EOPNOTSUPP', 'ENOSYS', 'EMLINK', 'EINVAL'])(
    'that reports %s renames files, but never over another file',
    (code) => {
      disk.instead = ([step]) => (step === 'linkSync' ? fails(code) : undefined);
      expect([moveFile(path('a'), path('c')), content('a'), content('c')]).toEqual([true, null, 'A']);
      expect([moveFile(path('b'), path('c')), content('b'), content('c')]).toEqual([false, 'B', 'A']);
      expect([createFile(path('d'), Buffer.from('D')), content('d')]).toEqual([true, 'D']);
      expect([createFile(path('d'), Buffer.from('X')), content('d')]).toEqual([false, 'D']);
      symlinkSync('nowhere', path('broken'));
      expect(moveFile(path('b'), path('broken'))).toBe(false);
      expect(names()).toEqual(['b', 'broken', 'c', 'd', 'sub']);
    },
  );

  it('is not the same as a disk that fails, on which nothing happens', () => {
    for (const code of ['EACCES', 'EIO', 'ENOSPC', '']) {
      disk.instead = ([step]) => (step === 'linkSync' ? fails(code) : undefined);
      expect(() => moveFile(path('a'), path('c'))).toThrow(code);
      expect(() => createFile(path('c'), Buffer.from('C'))).toThrow(code);
      expect(names()).toEqual(['a', 'b', 'sub']);
    }
  });
});

describe('a moved file', () => {
  it('has its new name only, and both folders are synced', () => {
    expect(moveFile(path('a'), path('sub/a'))).toBe(true);
    expect([content('a'), content('sub/a'), count('fsyncSync')]).toEqual([null, 'A', 2]);
    disk.calls = [];
    expect(moveFile(path('b'), path('c'))).toBe(true);
    expect([content('b'), content('c'), count('fsyncSync')]).toEqual([null, 'B', 1]);
  });

  it('stays where it is if the new name is taken, even by the file itself', () => {
    expect([moveFile(path('a'), path('b')), moveFile(path('a'), path('a'))]).toEqual([false, false]);
    expect([content('a'), content('b'), count('fsyncSync')]).toEqual(['A', 'B', 0]);
  });

  it('has its old name only if that can not be removed', () => {
    disk.instead = ([step, name]) => (step === 'rmSync' && name === path('a') ? fails('EPERM') : undefined);
    expect(() => moveFile(path('a'), path('c'))).toThrow('EPERM');
    expect(names()).toEqual(['a', 'b', 'sub']);
  });

  it('is moved even if another process removes the old name at the same time', () => {
    disk.instead = ([step, name]) => {
      if (step === 'rmSync' && name === path('a')) unlinkSync(path('a'));
      return undefined;
    };
    expect([moveFile(path('a'), path('c')), content('a'), content('c')]).toEqual([true, null, 'A']);
  });

  it('is renamed only where A and a are the same file', () => {
    const foreign = { dev: statSync(path('a')).dev, ino: statSync(path('a')).ino };
    const twin = (found: object | undefined) => {
      disk.calls = [];
      disk.instead = ([step, name]) => (step === 'lstatSync' && name === path('A') ? { value: found } : undefined);
    };
    for (const other of [undefined, { ...foreign, ino: foreign.ino + 1 }, { ...foreign, dev: foreign.dev + 1 }]) {
      twin(other);
      expect([moveFile(path('a'), path('A')), count('linkSync')]).toEqual([true, 1]);
      disk.instead = () => undefined;
      moveFile(path('A'), path('a'));
    }
    twin(foreign);
    expect([moveFile(path('a'), path('A')), count('linkSync'), count('renameSync')]).toEqual([true, 0, 1]);
    expect(names()).toEqual(['A', 'b', 'sub']);
    // other letters are another name, even if the inode numbers are the same
    disk.calls = [];
    disk.instead = ([step, name]) => (step === 'lstatSync' && name === path('c') ? { value: foreign } : undefined);
    expect([moveFile(path('A'), path('c')), count('linkSync')]).toEqual([true, 1]);
  });
});

describe('a file that is locked for a moment', () => {
  /** Makes this many renames fail. */
  const held = (times: number, code: string) => {
    let left = times;
    disk.calls = [];
    disk.instead = ([step]) => (step === 'renameSync' && left-- > 0 ? fails(code) : undefined);
  };
  const replace = () => replaceFile(path('a'), Buffer.from('new'), () => {});

  it.each(['EPERM', 'EACCES', 'EBUSY'])('is renamed with up to ten tries on Windows (%s)', (code) => {
    Object.defineProperty(process, 'platform', { value: 'win32' });
    const wait = vi.spyOn(Atomics, 'wait').mockReturnValue('timed-out');
    held(9, code);
    replace();
    expect([content('a'), count('renameSync'), wait.mock.calls.length]).toEqual(['new', 10, 9]);
    for (const [array, index, value, ms] of wait.mock.calls) {
      // Atomics.wait does not wait if the value differs
      expect([array[index as number], ms]).toEqual([value, 20]);
    }
    held(10, code);
    expect(replace).toThrow(code);
    expect(count('renameSync')).toBe(10);
    wait.mockRestore();
  });

  it('is tried once on other systems, and after other errors', () => {
    held(1, 'EBUSY');
    expect(replace).toThrow('EBUSY');
    expect(count('renameSync')).toBe(1);
    Object.defineProperty(process, 'platform', { value: 'win32' });
    for (const code of ['ENOENT', 'ENOSPC', '']) {
      held(1, code);
      expect(replace).toThrow(code);
      expect(count('renameSync')).toBe(1);
    }
    expect([content('a'), names()]).toEqual(['A', ['a', 'b', 'sub']]);
  });
});

describe('a file that replaces another', () => {
  const replace = () => replaceFile(path('a'), Buffer.from('new'), () => {});
  const of = (step: Step) => calls().filter(([name]) => name === step);
  const owner = (uid: number, gid: number, mode: number) => {
    disk.calls = [];
    const stats = { isFile: () => true, mode: 0o100000 + mode, uid, gid };
    disk.instead = ([step, name]) =>
      step === 'lstatSync' && name === path('a') ? { value: stats } : step === 'fchownSync' ? { value: undefined } : undefined;
  };

  it.runIf(platform !== 'win32')('gets the complete mode of the old file', () => {
    for (const mode of [0o640, 0o444, 0o777, 0o6755, 0o1600]) {
      owner(getuid?.() ?? 0, getgid?.() ?? 0, mode);
      replace();
      expect(of('fchmodSync').map(([, , given]) => given)).toEqual([mode]);
      expect(of('fchownSync')).toEqual([]);
      if (mode < 0o1000) expect(statSync(path('a')).mode & 0o777).toBe(mode);
    }
  });

  it('gets the owner of the old file, and then its mode again, which a change of owner may clear', () => {
    Object.assign(process, { getuid: () => 10, getgid: () => 20 });
    for (const [uid, gid] of [
      [11, 20],
      [10, 21],
      [11, 21],
    ]) {
      owner(uid, gid, 0o6755);
      replace();
      expect(of('fchownSync').map(([, , ...ids]) => ids)).toEqual([[uid, gid]]);
      const steps = calls().flatMap(([step, , mode]) => (/fch/.test(step) ? [step === 'fchmodSync' ? mode : step] : []));
      expect(steps).toEqual([0o6755, 'fchownSync', 0o6755]);
    }
    owner(10, 20, 0o644);
    replace();
    expect(of('fchownSync')).toEqual([]);
    // on systems without owners
    Object.assign(process, { getuid: undefined, getgid: undefined });
    owner(11, 21, 0o644);
    replace();
    expect(of('fchownSync')).toEqual([]);
    expect(content('a')).toBe('new');
  });

  it('belongs to the writer if only root may change owners', () => {
    Object.assign(process, { getuid: () => 10, getgid: () => 20 });
    owner(11, 21, 0o644);
    const before = disk.instead;
    disk.instead = (call) => (call[0] === 'fchownSync' ? fails('EPERM') : before(call));
    replace();
    expect([content('a'), of('fchmodSync').length]).toEqual(['new', 1]);
  });

  it('gets the mode of a file, but not of a link or a folder; a new file gets the usual mode', () => {
    symlinkSync('b', path('link'));
    replaceFile(path('link'), Buffer.from('L'), () => {});
    expect([content('link'), of('fchmodSync')]).toEqual(['L', []]);
    createFile(path('fresh'), Buffer.from('F'));
    expect(of('fchmodSync')).toEqual([]);
    expect(content('b')).toBe('B');
    const opened = calls().filter(([step, , flags]) => step === 'openSync' && flags === 'wx');
    expect(opened.map(([, , , mode]) => mode)).toEqual([0o666, 0o666]);
  });

  it('is written under a name that is not a level name', () => {
    const seen: unknown[] = [];
    replaceFile(path('a'), Buffer.from('new'), () => seen.push(...names().filter((name) => UNFINISHED.test(name))));
    expect(seen).toHaveLength(1);
    expect(names()).toEqual(['a', 'b', 'sub']);
    expect(() => replaceFile(path('a'), Buffer.from('X'), () => fails('changed'))).toThrow('changed');
    expect([content('a'), names()]).toEqual(['new', ['a', 'b', 'sub']]);
  });
});

it('tryFolder leaves nothing behind in the folder', () => {
  tryFolder(made.folder);
  expect(names()).toEqual(['a', 'b', 'sub']);
  expect(calls().some(([step, name]) => step === 'openSync' && String(name).startsWith(path('.gq-edit-')))).toBe(true);
  expect(() => tryFolder(path('nowhere'))).toThrow('ENOENT');
  disk.instead = ([step, , flags]) => (step === 'openSync' && flags === 'wx' ? fails('EROFS') : undefined);
  expect(() => tryFolder(made.folder)).toThrow('EROFS');
});

it('a folder that can not be synced is no error, and is closed again', () => {
  disk.instead = ([step, name]) => (step === 'openSync' && name === made.folder ? fails('EISDIR') : undefined);
  expect(createFile(path('c'), Buffer.from('C'))).toBe(true);
  expect(content('c')).toBe('C');
});

it('every opened file and folder is closed again, whatever fails', () => {
  const acts = [
    () => replaceFile(path('a'), Buffer.from('new'), () => {}),
    () => createFile(path('c'), Buffer.from('C')),
    () => moveFile(path('c'), path('d')),
  ];
  const total = { opened: 0, failed: 0 };
  for (const act of acts) {
    for (const failing of [null, 'fsyncSync', 'fchmodSync', 'linkSync', 'renameSync'] as const) {
      disk.calls = [];
      disk.instead = ([step]) => (step === failing ? fails('EIO') : undefined);
      try {
        act();
      } catch {
        total.failed++;
      }
      total.opened += count('openSync');
      expect([failing, count('closeSync')]).toEqual([failing, count('openSync')]);
    }
  }
  expect([total.opened > 10, total.failed > 3]).toEqual([true, true]);
});

it('a name is taken by a file, a folder, a link or a broken link', () => {
  symlinkSync('nowhere', path('broken'));
  writeFileSync(path('c'), '');
  expect(['a', 'sub', 'broken', 'c', 'd', 'sub/a'].map((name) => isTaken(path(name)))).toEqual([
    true,
    true,
    true,
    true,
    false,
    false,
  ]);
});
