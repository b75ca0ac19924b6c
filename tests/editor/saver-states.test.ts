import { beforeEach, describe, expect, it } from 'vitest';
import { createEditedLevel, type EditedLevel, moveObjects, setLevelProperty } from '../../editor/core/document/index.ts';
import { createBrowserStorage, createSaver, type LevelStorage, readText, type Saver } from '../../editor/core/files/index.ts';
import type { DiskBase } from '../../editor/core/files/known-disk.ts';
import { storageError } from '../../editor/core/files/level-storage.ts';
import { formatLevel, type LevelFile } from '../../schema/index.ts';
import { breathe, createKeyValues, createLine, FILE, TurnedClock } from './stage.ts';

let disk: LevelStorage;
let line: ReturnType<typeof createLine>;
let clock: TurnedClock;
let level: EditedLevel;
let etag: string | null;

beforeEach(async () => {
  disk = createBrowserStorage(createKeyValues(), null, () => 0);
  line = createLine(disk);
  clock = new TurnedClock();
  const written = await disk.write('07', formatLevel(FILE), null);
  etag = written.ok ? written.value.etag : null;
  level = createEditedLevel(FILE);
});

const saverOf = (more: { storage?: LevelStorage; base?: DiskBase; unwritable?: string } = {}): Saver =>
  createSaver('07', level, { storage: line, timers: clock, base: { file: level.file(), etag }, ...more });
const move = (dx: number) => level.change('Move', moveObjects(['aa'], dx, 0));
const x = (file: LevelFile) => file.asteroids?.[0].x;
const onDisk = async (): Promise<LevelFile> => {
  const answer = await disk.read('07');
  const reading = answer.ok ? readText(answer.value.text ?? '') : null;
  if (!reading?.ok) throw new Error('not on the disk');
  return reading.file;
};
const byOthers = async (change: (file: LevelFile) => LevelFile) => {
  const answer = await disk.read('07');
  if (answer.ok) await disk.write('07', formatLevel(change(await onDisk())), answer.value.etag);
};
/** The times of the attempts to write, ms. */
function timesOfWrites(): number[] {
  const times: number[] = [];
  const write = line.write.bind(line);
  line.write = (...all) => {
    times.push(clock.now());
    return write(...all);
  };
  return times;
}

describe('when a saver writes', () => {
  it('200 ms after the last change, and 2 s after the first at the latest', async () => {
    const times = timesOfWrites();
    saverOf();
    move(1);
    await clock.pass(150);
    move(1);
    await clock.pass(1000);
    expect(times).toEqual([350]);
    const start = clock.now();
    for (let i = 0; i < 30; i++) {
      move(1);
      await clock.pass(100);
    }
    await clock.pass(1000);
    expect(times.slice(1).map((time) => time - start)).toEqual([2000, 3100]);
  });

  it('again after 0.5, 1, 2 and 5 s, and then every 10 s without an answer; an answer resets this', async () => {
    const times = timesOfWrites();
    const saver = saverOf();
    line.isCut = true;
    move(1);
    await clock.pass(40_000);
    const waits = () => times.map((time, i) => time - (times[i - 1] ?? 0));
    expect(waits()).toEqual([200, 500, 1000, 2000, 5000, 10_000, 10_000, 10_000]);
    // neither a change nor its undoing leads to more attempts
    move(1);
    await clock.pass(1000);
    expect(times).toHaveLength(8);
    // at once when the connection may be back, and then with the first intervals again
    const again = clock.now();
    saver.retry();
    await clock.pass(2000);
    expect(times.slice(8).map((time) => time - again)).toEqual([0, 500, 1500]);
    line.isCut = false;
    saver.retry();
    saver.retry();
    await clock.pass(0);
    expect(times).toHaveLength(12);
    expect(saver.store.getState()).toEqual({ kind: 'saved' });
    times.length = 0;
    line.isCut = true;
    const start = clock.now();
    move(1);
    await clock.pass(2000);
    expect(times.map((time) => time - start)).toEqual([200, 700, 1700]);
  });

  it('at once if the page did not know at its start that the version is on disk', async () => {
    const saver = saverOf({ base: { file: FILE, etag: null } });
    expect(saver.store.getState()).toEqual({ kind: 'unsaved' });
    expect(saver.isUnsaved()).toBe(true);
    const times = timesOfWrites();
    await clock.pass(500);
    expect(times[0]).toBe(200);
  });

  it('changes since an older base from which it continues', async () => {
    const saver = saverOf();
    const older = { ...FILE, name: 'older' };
    saver.restart({ file: older, etag });
    expect([saver.isUnsaved(), saver.base().file]).toEqual([true, older]);
    await clock.pass(500);
    expect([line.writes, saver.isUnsaved()]).toEqual([1, false]);
  });

  it('nothing if there are no changes, if it is closed, or if it may not write', async () => {
    const saver = saverOf();
    expect(await saver.flush()).toBe(true);
    saver.retry();
    await clock.pass(5000);
    expect(line.writes).toBe(0);
    saver.setReadOnly('another tab');
    move(1);
    expect(await saver.flush()).toBe(false);
    saver.retry();
    await clock.pass(5000);
    expect(line.writes).toBe(0);
    saver.setReadOnly(null);
    saver.close();
    move(1);
    expect(await saver.flush()).toBe(false);
    await clock.pass(60_000);
    expect(line.writes).toBe(0);
  });

  it('at once on request, including changes in the meantime, and reports a failure', async () => {
    const saver = saverOf();
    let open = () => {};
    line.gate = new Promise((resolve) => {
      open = () => resolve();
    });
    move(1);
    const flushed = saver.flush();
    await breathe();
    move(1);
    open();
    expect(await flushed).toBe(true);
    expect([line.writes, x(await onDisk())]).toEqual([2, 12]);
    line.isCut = true;
    move(1);
    expect(await saver.flush()).toBe(false);
    expect(line.writes).toBe(5);
  });

  it('under the new id after a rename', async () => {
    const saver = saverOf();
    const renamed = await disk.rename('07', '09', etag ?? '');
    saver.moved('09', renamed.ok ? (renamed.value.etag ?? '') : '');
    move(1);
    await clock.pass(500);
    expect(saver.store.getState()).toEqual({ kind: 'saved' });
    const answer = await disk.read('09');
    expect(answer.ok && answer.value.text).toContain('"x": 11');
  });
});

describe('what a saver shows', () => {
  it('while another page has the level: only its own changes are unsaved', async () => {
    const saver = saverOf();
    const state = () => saver.store.getState();
    saver.setReadOnly('another tab', true);
    expect(state()).toEqual({ kind: 'readOnly', why: 'another tab', unsaved: false });
    level.replace('Shown', { ...level.file(), name: 'theirs' });
    expect(state()).toEqual({ kind: 'readOnly', why: 'another tab', unsaved: false });
    saver.setReadOnly('another tab');
    expect(state()).toEqual({ kind: 'readOnly', why: 'another tab', unsaved: true });
    level.undo();
    expect(state()).toEqual({ kind: 'readOnly', why: 'another tab', unsaved: false });
    saver.setReadOnly(null);
    expect(state()).toEqual({ kind: 'saved' });
  });

  it('of a file that is not writable: the reason, but not during another attempt', async () => {
    const saver = saverOf({ unwritable: 'its folder can not be written' });
    const kinds = [saver.store.getState().kind];
    saver.store.subscribe(({ kind }) => kinds.push(kind));
    line.readOnly = 'its folder can not be written';
    saver.refresh();
    await breathe();
    expect(saver.store.getState()).toEqual({ kind: 'readOnly', why: 'its folder can not be written', unsaved: false });
    move(1);
    await clock.pass(201);
    expect(saver.store.getState()).toEqual({ kind: 'readOnly', why: 'its folder can not be written', unsaved: true });
    expect(kinds).toContain('saving');
    level.undo();
    expect(saver.store.getState().kind).toBe('readOnly');
  });

  it('of an error: what is wrong and what to do; no answer differs from a failing disk', async () => {
    for (const [code, kind] of [
      ['unreachable', 'offline'],
      ['disk-full', 'failing'],
      ['failed', 'failing'],
      ['unexpected', 'failing'],
    ] as const) {
      const storage = { ...line, write: async () => ({ ok: false, error: storageError(code, 'why', 'do') }) as const };
      const saver = saverOf({ storage });
      move(1);
      await clock.pass(201);
      expect(saver.store.getState()).toEqual({ kind, message: 'why', hint: 'do' });
      // only a definite refusal shows that the version is not on disk
      expect(saver.base().sent ?? []).toHaveLength(code === 'disk-full' ? 0 : 1);
      level.undo();
      expect(saver.isUnsaved()).toBe(code !== 'disk-full');
      saver.close();
    }
  });

  it('of a file that is gone or not a level any more: it waits for keepMine', async () => {
    for (const reason of ['deleted', 'invalid', 'unreadable'] as const) {
      const text = reason === 'invalid' ? '{' : null;
      const read: LevelStorage['read'] = async (id) => {
        const answer = await disk.read(id);
        if (reason === 'deleted') return { ok: false, error: storageError('unknown-level', 'gone', 'look') };
        return answer.ok ? { ...answer, value: { ...answer.value, text, etag: '"other"' } } : answer;
      };
      const saver = saverOf({ storage: { ...line, read } });
      const displaced = { kind: reason === 'deleted' ? 'deleted' : 'unreadable' };
      saver.refresh();
      await breathe();
      const shown = saver.store.getState();
      expect(shown).toMatchObject(displaced);
      expect(shown.kind === 'unreadable' && shown.problems.length).toBe({ deleted: false, invalid: 1, unreadable: 0 }[reason]);
      move(1);
      const mine = level.file();
      saver.resolve(new Map());
      saver.takeTheirs();
      saver.retry();
      expect(await saver.flush()).toBe(false);
      await clock.pass(5000);
      expect(saver.store.getState()).toMatchObject(displaced);
      expect([level.file(), (await onDisk()).asteroids?.[0].x]).toEqual([mine, 10]);
      saver.close();
      level.undo();
    }
  });

  it('of a file that comes back unchanged: nothing, and it continues', async () => {
    const answers = [storageError('unknown-level', 'gone', 'look')];
    const read: LevelStorage['read'] = async (id) => {
      const error = answers.shift();
      return error === undefined ? disk.read(id) : { ok: false, error };
    };
    const saver = saverOf({ storage: { ...line, read } });
    saver.refresh();
    await breathe();
    expect(saver.store.getState().kind).toBe('deleted');
    move(1);
    // it reads even a known version again, because it is blocked
    saver.refresh(etag);
    await clock.pass(500);
    expect(saver.store.getState()).toEqual({ kind: 'saved' });
    expect(x(await onDisk())).toBe(11);
  });

  it('nothing more once it is closed', async () => {
    const saver = saverOf();
    saver.close();
    const before = saver.store.getState();
    saver.refresh();
    saver.setReadOnly('why');
    await clock.pass(1000);
    expect(saver.store.getState()).toBe(before);
  });
});

describe('what a saver reads', () => {
  it('is nothing for a version that it knows', async () => {
    let reads = 0;
    const read: LevelStorage['read'] = (id) => {
      reads++;
      return disk.read(id);
    };
    const saver = saverOf({ storage: { ...line, read } });
    saver.refresh(etag);
    await breathe();
    expect(reads).toBe(0);
    saver.refresh(null);
    saver.refresh('"other"');
    await breathe();
    expect(reads).toBe(2);
  });

  it('does not hide that writes get no answer', async () => {
    const saver = saverOf();
    line.isCut = true;
    move(1);
    await clock.pass(300);
    expect(saver.store.getState().kind).toBe('offline');
    // an error of reading changes nothing
    saver.refresh();
    await breathe();
    expect(saver.store.getState().kind).toBe('offline');
    const { write } = line;
    line.write = async () => ({ ok: false, error: storageError('unreachable', 'nobody answers', 'start it') });
    line.isCut = false;
    saver.refresh();
    await breathe();
    expect(saver.store.getState().kind).toBe('offline');
    line.write = write;
  });

  it('becomes a separate step, and an unknown change is a conflict only for a page that may write', async () => {
    const saver = saverOf();
    saver.setReadOnly('another tab');
    level.change('Rename', setLevelProperty('name', 'mine'));
    await byOthers((file) => ({ ...file, name: 'theirs' }));
    saver.refresh();
    await breathe();
    expect(saver.store.getState()).toMatchObject({ kind: 'readOnly', unsaved: true });
    expect(level.file().name).toBe('mine');
    saver.setReadOnly(null);
    await clock.pass(500);
    expect(saver.store.getState()).toMatchObject({ kind: 'conflict', conflicts: [{ key: 'name' }] });
    saver.takeTheirs();
    expect([level.file().name, level.labels().at(-1)]).toEqual(['theirs', 'Taken from the disk']);
    expect(saver.store.getState()).toEqual({ kind: 'saved' });
    level.undo();
    await clock.pass(500);
    expect((await onDisk()).name).toBe('mine');
    // without a conflict
    saver.keepMine();
    saver.takeTheirs();
    saver.resolve(new Map());
    await clock.pass(500);
    expect([level.file().name, line.writes, saver.store.getState().kind]).toEqual(['mine', 2, 'saved']);
  });

  it('is reported to the journal, as are sent versions', async () => {
    const told: string[] = [];
    const saver = createSaver('07', level, {
      storage: line,
      timers: clock,
      base: { file: level.file(), etag },
      onDisk: (file) => told.push(`disk ${x(file)}`),
      onSent: (file) => {
        told.push(`sent ${x(file)}`);
        return undefined;
      },
    });
    move(1);
    await clock.pass(500);
    await byOthers((file) => ({ ...file, asteroids: [{ id: 'aa', x: 99, y: 20, radius: 16 }] }));
    saver.refresh();
    await breathe();
    expect(told).toEqual(['sent 11', 'disk 11', 'disk 99']);
    expect(level.labels()).toEqual(['Move', 'Changed on disk']);
  });
});
