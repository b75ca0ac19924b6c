import { existsSync, lstatSync, readdirSync, readFileSync, rmSync, utimesSync, writeFileSync } from 'node:fs';
import { hostname } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { ASIDE, oneAtATime } from '../../cli/serve/one-at-a-time.ts';
import { makeFolder } from './running.ts';

// Waits take no time here: they are counted, and a hook acts in the middle of them.

const waits = vi.hoisted(() => ({ ms: [] as number[], meanwhile: (() => undefined) as (count: number) => void }));
vi.mock('node:timers/promises', async (original) => ({
  ...(await original<typeof import('node:timers/promises')>()),
  setTimeout: async (ms: number) => {
    waits.ms.push(ms);
    waits.meanwhile(waits.ms.length);
  },
}));

const renamed = vi.hoisted(() => ({ to: [] as string[] }));
vi.mock('node:fs', async (original) => {
  const fs = await original<typeof import('node:fs')>();
  return {
    ...fs,
    renameSync(from: string, to: string) {
      renamed.to.push(to);
      fs.renameSync(from, to);
    },
  };
});

let made: ReturnType<typeof makeFolder>;
let lock: string;
beforeEach(() => {
  made = makeFolder({});
  lock = join(made.folder, '.gq-edit.lock');
  waits.ms = [];
  waits.meanwhile = () => undefined;
  renamed.to = [];
});
afterEach(() => {
  vi.restoreAllMocks();
  made.remove();
});
const names = () => readdirSync(made.folder);
/** A lock that was modified this many ms ago. */
const lockOf = (text: string, age = 0): void => {
  writeFileSync(lock, text);
  const then = (Date.now() - age) / 1000;
  utimesSync(lock, then, then);
};
const here = `${process.pid} ${hostname()} 0123456789abcdef`;

describe('work on a folder', () => {
  it('happens under a private lock that names its owner, and that is removed when the work is done or fails', async () => {
    const result = await oneAtATime(made.folder, () => {
      expect(readFileSync(lock, 'utf8')).toMatch(new RegExp(`^${process.pid} ${hostname()} [0-9a-f]{16}$`));
      if (process.platform !== 'win32') expect(lstatSync(lock).mode & 0o777).toBe(0o600);
      return 7;
    });
    expect([result, names(), waits.ms]).toEqual([7, [], []]);
    const fail = () => {
      throw new Error('failed');
    };
    await expect(oneAtATime(made.folder, fail)).rejects.toThrow('failed');
    expect(names()).toEqual([]);
    await expect(oneAtATime(join(made.folder, 'nowhere'), () => 7)).rejects.toThrow('ENOENT');
  });

  it('waits for a living process, 10 ms each time, and does not touch its lock', async () => {
    lockOf(here);
    waits.meanwhile = (count) => {
      expect(readFileSync(lock, 'utf8')).toBe(here);
      if (count === 5) rmSync(lock);
    };
    await oneAtATime(made.folder, () => {});
    expect(waits.ms).toEqual([10, 10, 10, 10, 10]);
  });

  it('is refused after 15 s of waiting', async () => {
    lockOf(here);
    let done = false;
    const work = oneAtATime(made.folder, () => {
      done = true;
    });
    await expect(work).rejects.toMatchObject({ code: 'busy', message: expect.stringContaining(lock) });
    expect([waits.ms.reduce((sum, ms) => sum + ms, 0), done, readFileSync(lock, 'utf8')]).toEqual([15_000, false, here]);
  });

  it('waits for a lock of another machine until it is 10 s old, in whichever direction its clock is wrong', async () => {
    for (const [age, isStale] of [
      [9000, false],
      [-9000, false],
      [11_000, true],
      [-11_000, true],
    ] as const) {
      waits.ms = [];
      lockOf('1 elsewhere 0123456789abcdef', age);
      waits.meanwhile = (count) => {
        if (count === 3) rmSync(lock, { force: true });
      };
      await oneAtATime(made.folder, () => {});
      expect([age, waits.ms.length, names()]).toEqual([age, isStale ? 1 : 3, []]);
    }
    // under a name by which the next run knows it if this process is killed here
    expect(renamed.to).toHaveLength(2);
    for (const name of renamed.to) expect(name.slice(made.folder.length + 1)).toMatch(ASIDE);
  });

  it('does not wait for an ended process of this machine, but does for one of another user', async () => {
    const kill = vi.spyOn(process, 'kill');
    for (const [code, waited] of [
      ['ESRCH', 1],
      ['EPERM', 3],
    ] as const) {
      waits.ms = [];
      kill.mockImplementation((pid, signal) => {
        expect([pid, signal]).toEqual([4711, 0]);
        throw Object.assign(new Error(code), { code });
      });
      lockOf(`4711 ${hostname()} 0123456789abcdef`);
      waits.meanwhile = (count) => {
        if (count === 3) rmSync(lock, { force: true });
      };
      await oneAtATime(made.folder, () => {});
      expect([code, waits.ms.length, names()]).toEqual([code, waited, []]);
    }
    // a process of another machine is not looked up here
    kill.mockClear();
    lockOf('4711 elsewhere 0123456789abcdef');
    waits.meanwhile = () => rmSync(lock, { force: true });
    await oneAtATime(made.folder, () => {});
    expect(kill).not.toHaveBeenCalled();
  });

  it('does not remove the lock if another process holds it when the work is done', async () => {
    await oneAtATime(made.folder, () => writeFileSync(lock, 'theirs'));
    expect(readFileSync(lock, 'utf8')).toBe('theirs');
    rmSync(lock);
    await oneAtATime(made.folder, () => rmSync(lock));
    expect(existsSync(lock)).toBe(false);
  });
});
