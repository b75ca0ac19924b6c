import { beforeEach, describe, expect, it } from 'vitest';
import {
  addObject,
  createEditedLevel,
  type EditedLevel,
  moveObjects,
  setLevelProperty,
} from '../../editor/core/document/index.ts';
import {
  type Answer,
  createBrowserStorage,
  createSaver,
  type LevelStorage,
  readText,
  type Saver,
} from '../../editor/core/files/index.ts';
import { formatLevel, type LevelFile } from '../../schema/index.ts';
import { breathe, createKeyValues, createLine, FILE, TurnedClock } from './stage.ts';

let disk: LevelStorage;
let line: ReturnType<typeof createLine>;
let clock: TurnedClock;
let level: EditedLevel;
let saver: Saver;
const move = (dx: number) => level.change('Move', moveObjects(['aa'], dx, 0));
const state = () => saver.store.getState();

const onDisk = async (): Promise<LevelFile> => {
  const answer = await disk.read('07');
  const reading = answer.ok ? readText(answer.value.text ?? '') : null;
  if (!reading?.ok) throw new Error('not on the disk');
  return reading.file;
};
/** Another program writes the file. */
const byOthers = async (change: (file: LevelFile) => LevelFile) => {
  const answer = await disk.read('07');
  if (!answer.ok) throw new Error('not on the disk');
  await disk.write('07', formatLevel(change(await onDisk())), answer.value.etag);
};

beforeEach(async () => {
  disk = createBrowserStorage(createKeyValues(), null, () => 0);
  line = createLine(disk);
  clock = new TurnedClock();
  const written = await disk.write('07', formatLevel(FILE), null);
  level = createEditedLevel(FILE);
  saver = createSaver('07', level, {
    storage: line,
    timers: clock,
    base: { file: level.file(), etag: written.ok ? written.value.etag : null },
  });
});

describe('saving', () => {
  it('happens within half a second after the last change, once for many', async () => {
    expect(state()).toEqual({ kind: 'saved' });
    for (let i = 0; i < 10; i++) {
      move(1);
      await clock.pass(50);
    }
    expect(state()).toEqual({ kind: 'unsaved' });
    await clock.pass(500);
    expect(state()).toEqual({ kind: 'saved' });
    expect(line.writes).toBe(1);
    expect((await onDisk()).asteroids?.[0].x).toBe(20);
  });

  it('does not wait for a pause forever', async () => {
    for (let i = 0; i < 50; i++) {
      move(1);
      await clock.pass(100);
    }
    expect(line.writes).toBeGreaterThanOrEqual(2);
    expect(line.writes).toBeLessThanOrEqual(4);
  });

  it('waits for the journal, but not forever', async () => {
    saver.close();
    let noted = () => {};
    const onSent = () =>
      new Promise<void>((resolve) => {
        noted = resolve;
      });
    saver = createSaver('07', level, { storage: line, timers: clock, base: saver.base(), onSent });
    move(1);
    await clock.pass(500);
    expect([line.writes, state().kind]).toEqual([0, 'saving']);
    noted();
    await clock.pass(1);
    expect([line.writes, state().kind]).toEqual([1, 'saved']);
    move(1);
    await clock.pass(2000);
    expect([line.writes, state().kind]).toEqual([2, 'saved']);
    // another page has taken over the level in the meantime
    move(1);
    await clock.pass(300);
    saver.setReadOnly('another tab');
    noted();
    await clock.pass(5000);
    expect([line.writes, state().kind]).toEqual([2, 'readOnly']);
  });

  it('leaves out a drag in progress', async () => {
    const drag = level.begin('Drag');
    drag.set(moveObjects(['aa'], 100, 0));
    level.subscribe(() => {});
    await clock.pass(1000);
    expect(line.writes).toBe(0);
    drag.commit();
    await clock.pass(500);
    expect((await onDisk()).asteroids?.[0].x).toBe(110);
  });

  it('sends at most one request at a time, and writes later changes after it', async () => {
    let open = () => {};
    line.gate = new Promise((resolve) => {
      open = () => resolve();
    });
    move(1);
    await clock.pass(300);
    expect(state()).toEqual({ kind: 'saving' });
    move(1);
    await clock.pass(5000);
    expect(line.writes).toBe(1);
    line.gate = null;
    open();
    await clock.pass(500);
    expect(line.writes).toBe(2);
    expect((await onDisk()).asteroids?.[0].x).toBe(12);
    expect(state()).toEqual({ kind: 'saved' });
  });

  it('writes nothing if undo leads back to the version on disk', async () => {
    move(1);
    level.undo();
    expect(state()).toEqual({ kind: 'saved' });
    await clock.pass(5000);
    expect(line.writes).toBe(0);
  });

  it('retries at growing intervals without an answer, and at once when the connection is back', async () => {
    line.isCut = true;
    move(1);
    await clock.pass(60_000);
    expect(state()).toMatchObject({ kind: 'offline' });
    expect(line.writes).toBeLessThan(15);
    const before = line.writes;
    move(1);
    await clock.pass(100);
    expect(line.writes).toBe(before);
    line.isCut = false;
    saver.retry();
    await clock.pass(1);
    expect(state()).toEqual({ kind: 'saved' });
    expect((await onDisk()).asteroids?.[0].x).toBe(12);
  });

  it('writes nothing while it may not, and everything once it may', async () => {
    saver.setReadOnly('another tab');
    move(1);
    await clock.pass(5000);
    expect(state()).toEqual({ kind: 'readOnly', why: 'another tab', unsaved: true });
    expect(line.writes).toBe(0);
    saver.setReadOnly(null);
    await clock.pass(500);
    expect((await onDisk()).asteroids?.[0].x).toBe(11);
  });
});

describe('a file that is not writable', () => {
  it('is tried again, and gets everything once it is writable', async () => {
    line.readOnly = 'its folder can not be written';
    move(1);
    await clock.pass(500);
    expect(state()).toEqual({ kind: 'readOnly', why: 'its folder can not be written', unsaved: true });
    move(1);
    await clock.pass(60_000);
    expect(state()).toEqual({ kind: 'readOnly', why: 'its folder can not be written', unsaved: true });
    expect(line.writes).toBeLessThan(15);
    line.readOnly = null;
    await clock.pass(10_000);
    expect(state()).toEqual({ kind: 'saved' });
    expect((await onDisk()).asteroids?.[0].x).toBe(12);
  });

  it('is reported before any change, and until it is writable', async () => {
    line.readOnly = 'the file can not be written';
    saver.refresh();
    await breathe();
    expect(state()).toEqual({ kind: 'readOnly', why: 'the file can not be written', unsaved: false });
    line.readOnly = null;
    saver.refresh();
    await breathe();
    expect(state()).toEqual({ kind: 'saved' });
  });
});

describe('a change on the disk', () => {
  it('appears at once without unsaved changes, as a step that can be undone', async () => {
    await byOthers((file) => ({ ...file, name: 'theirs' }));
    saver.refresh();
    await breathe();
    expect(level.file().name).toBe('theirs');
    expect(state()).toEqual({ kind: 'saved' });
    level.undo();
    await clock.pass(500);
    expect((await onDisk()).name).toBe('base');
  });

  it('is merged with unsaved changes, and both are written', async () => {
    move(5);
    await byOthers((file) => ({ ...file, name: 'theirs' }));
    saver.refresh();
    await clock.pass(500);
    expect(await onDisk()).toMatchObject({ name: 'theirs', asteroids: [{ x: 15 }] });
    expect(state()).toEqual({ kind: 'saved' });
  });

  it('that was not reported is found when writing', async () => {
    move(5);
    await byOthers((file) => ({ ...file, name: 'theirs' }));
    await clock.pass(500);
    expect(await onDisk()).toMatchObject({ name: 'theirs', asteroids: [{ x: 15 }] });
    expect(level.file().name).toBe('theirs');
  });

  it('does not disturb a drag in progress', async () => {
    const drag = level.begin('Drag');
    drag.set(moveObjects(['aa'], 7, 0));
    await byOthers((file) => ({ ...file, name: 'theirs' }));
    saver.refresh();
    await clock.pass(500);
    expect(await onDisk()).toMatchObject({ name: 'theirs', asteroids: [{ x: 17 }] });
  });

  it('that was read before our own write does not restore the old state', async () => {
    let open = () => {};
    line.gate = new Promise((resolve) => {
      open = () => resolve();
    });
    move(5);
    await clock.pass(300);
    // an event arrives during our write
    saver.refresh();
    await breathe();
    line.gate = null;
    open();
    await clock.pass(500);
    expect(level.file().asteroids?.[0].x).toBe(15);
    expect((await onDisk()).asteroids?.[0].x).toBe(15);
  });

  it('that was read before our own write, and reported after it, does not either', async () => {
    let open = () => {};
    line.readGate = new Promise((resolve) => {
      open = () => resolve();
    });
    saver.refresh();
    await breathe();
    move(5);
    await clock.pass(500);
    line.readGate = null;
    open();
    await clock.pass(500);
    expect(level.file().asteroids?.[0].x).toBe(15);
    expect((await onDisk()).asteroids?.[0].x).toBe(15);
  });

  it('that was read during the second of two writes does not either', async () => {
    const gates: (() => void)[] = [];
    const write = line.write.bind(line);
    line.write = async (...all) => {
      await new Promise<void>((resolve) => gates.push(resolve));
      return write(...all);
    };
    await byOthers((file) => ({ ...file, name: 'theirs' }));
    move(5);
    await clock.pass(300);
    // waits for the first write, which conflicts with the file; the merged level is written at once
    const flushed = saver.flush();
    let openRead = () => {};
    line.readGate = new Promise((resolve) => {
      openRead = () => resolve();
    });
    saver.refresh();
    gates[0]();
    await breathe();
    // a version that was read before the write arrives after the answer to the write
    gates[1]();
    await flushed;
    openRead();
    await clock.pass(500);
    expect(level.file().asteroids?.[0].x).toBe(15);
    expect(await onDisk()).toMatchObject({ name: 'theirs', asteroids: [{ x: 15 }] });
  });

  it('of the same property is a conflict: nothing is written until the user chooses', async () => {
    level.change('Rename', setLevelProperty('name', 'mine'));
    move(5);
    await byOthers((file) => ({ ...file, name: 'theirs', asteroids: [{ id: 'aa', x: 99, y: 20, radius: 16 }] }));
    await clock.pass(500);
    const asked = state();
    expect(asked).toMatchObject({ kind: 'conflict', conflicts: [{ key: 'name' }, { key: 'asteroids/aa/place' }] });
    level.change('Add', addObject('nova', 1, 1));
    await clock.pass(5000);
    expect((await onDisk()).name).toBe('theirs');
    saver.resolve(new Map([['asteroids/aa/place', 'theirs']]));
    await clock.pass(500);
    expect(await onDisk()).toMatchObject({ name: 'mine', asteroids: [{ x: 99 }], novae: [{ x: 1 }] });
    expect(state()).toEqual({ kind: 'saved' });
  });

  it('can be accepted as it is, or overwritten', async () => {
    for (const act of ['takeTheirs', 'keepMine'] as const) {
      level.change('Rename', setLevelProperty('name', `mine ${act}`));
      await byOthers((file) => ({ ...file, name: `theirs ${act}` }));
      await clock.pass(500);
      expect(state()).toMatchObject({ kind: 'conflict' });
      saver[act]();
      await clock.pass(500);
      expect(state()).toEqual({ kind: 'saved' });
      expect((await onDisk()).name).toBe(act === 'keepMine' ? 'mine keepMine' : 'theirs takeTheirs');
      expect(level.file().name).toBe((await onDisk()).name);
    }
  });

  it('that deletes the level leaves it in the page, which can write it again', async () => {
    const answer = await disk.read('07');
    if (answer.ok) await disk.remove('07', answer.value.etag ?? '');
    saver.refresh();
    await breathe();
    expect(state()).toEqual({ kind: 'deleted' });
    move(5);
    await clock.pass(5000);
    expect((await disk.list()).ok && (await disk.read('07')).ok).toBe(false);
    saver.keepMine();
    await clock.pass(500);
    expect((await onDisk()).asteroids?.[0].x).toBe(15);
    expect(state()).toEqual({ kind: 'saved' });
  });

  it('that is not a valid level is never overwritten unasked', async () => {
    const damaged = {
      ...line,
      read: async (id: string) => {
        const answer = await disk.read(id);
        return answer.ok
          ? { ...answer, value: { ...answer.value, text: '{ "version": 1, ', etag: `"${'f'.repeat(64)}"` } }
          : answer;
      },
    };
    saver.close();
    saver = createSaver('07', level, { storage: damaged, timers: clock, base: saver.base() });
    saver.refresh();
    await breathe();
    expect(state()).toMatchObject({ kind: 'unreadable', problems: [{ code: 'truncated-json' }] });
    move(5);
    await clock.pass(5000);
    expect((await onDisk()).asteroids?.[0].x).toBe(10);
  });
});

describe('a write whose answer was lost', () => {
  beforeEach(async () => {
    line.losesAnswers = true;
    move(5);
    await clock.pass(300);
    expect(state()).toMatchObject({ kind: 'offline' });
    expect((await onDisk()).asteroids?.[0].x).toBe(15);
    line.isCut = true;
    line.losesAnswers = false;
  });
  const mend = async () => {
    line.isCut = false;
    saver.retry();
    await clock.pass(30_000);
  };

  it('is no change by others: later changes are based on it', async () => {
    move(1);
    await mend();
    expect(state()).toEqual({ kind: 'saved' });
    expect((await onDisk()).asteroids?.[0].x).toBe(16);
  });

  it('may be on disk or not: undoing it is written', async () => {
    level.undo();
    expect(saver.isUnsaved()).toBe(true);
    line.isCut = false;
    // the server sends its state as soon as it is back
    saver.refresh();
    await clock.pass(30_000);
    expect(level.file().asteroids?.[0].x).toBe(10);
    expect((await onDisk()).asteroids?.[0].x).toBe(10);
    expect(state()).toEqual({ kind: 'saved' });
  });

  it('may be an earlier one of several writes', async () => {
    move(1);
    await clock.pass(30_000);
    move(1);
    await mend();
    expect(state()).toEqual({ kind: 'saved' });
    expect((await onDisk()).asteroids?.[0].x).toBe(17);
  });

  it('and that others have changed elsewhere is merged with later changes', async () => {
    move(1);
    await byOthers((file) => ({ ...file, name: 'theirs' }));
    await mend();
    expect(state()).toEqual({ kind: 'saved' });
    expect(await onDisk()).toMatchObject({ name: 'theirs', asteroids: [{ x: 16 }] });
  });

  it('and that others have changed elsewhere is undone if it was undone here', async () => {
    level.undo();
    await byOthers((file) => ({ ...file, name: 'theirs' }));
    await mend();
    expect(state()).toEqual({ kind: 'saved' });
    expect(await onDisk()).toMatchObject({ name: 'theirs', asteroids: [{ x: 10 }] });
  });

  it('is recognised after others have removed and restored the file', async () => {
    await mend();
    line.write = async (id, text, base) => {
      const written = await disk.write(id, text, base);
      if (!written.ok) return written;
      // before the answer, the level is removed, as by a checkout
      await disk.rename('07', '07-away', written.value.etag ?? '');
      return disk.read('07') as Promise<Answer<never>>;
    };
    move(1);
    await clock.pass(300);
    expect(state()).toMatchObject({ kind: 'deleted' });
    move(1);
    const away = await disk.read('07-away');
    await disk.rename('07-away', '07', away.ok ? (away.value.etag ?? '') : '');
    line.write = (id, text, base) => disk.write(id, text, base);
    saver.refresh();
    await clock.pass(500);
    expect(state()).toEqual({ kind: 'saved' });
    expect((await onDisk()).asteroids?.[0].x).toBe(17);
  });

  it('and that others have changed at the same place is a conflict', async () => {
    move(1);
    await byOthers((file) => ({ ...file, asteroids: [{ id: 'aa', x: 99, y: 20, radius: 16 }] }));
    await mend();
    expect(state()).toMatchObject({ kind: 'conflict', conflicts: [{ key: 'asteroids/aa/place' }] });
    saver.resolve(new Map([['asteroids/aa/place', 'theirs']]));
    await clock.pass(500);
    expect((await onDisk()).asteroids?.[0].x).toBe(99);
    expect(state()).toEqual({ kind: 'saved' });
  });
});
