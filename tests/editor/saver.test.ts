import { beforeEach, describe, expect, it } from 'vitest';
import { addObject, createEditedLevel, type EditedLevel, moveObjects, setLevelProperty } from '../../editor/document/index.ts';
import {
  type Answer,
  createBrowserStorage,
  createSaver,
  type LevelStorage,
  readText,
  type Saver,
} from '../../editor/files/index.ts';
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
  it('follows the last change within half a second, once for many', async () => {
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
    // another page has taken the level over meanwhile
    move(1);
    await clock.pass(300);
    saver.setReadOnly('another tab');
    noted();
    await clock.pass(5000);
    expect([line.writes, state().kind]).toEqual([2, 'readOnly']);
  });

  it('leaves a drag that is going on out of it', async () => {
    const drag = level.begin('Drag');
    drag.set(moveObjects(['aa'], 100, 0));
    level.subscribe(() => {});
    await clock.pass(1000);
    expect(line.writes).toBe(0);
    drag.commit();
    await clock.pass(500);
    expect((await onDisk()).asteroids?.[0].x).toBe(110);
  });

  it('has one request on its way at most, and writes what came meanwhile after it', async () => {
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

  it('writes nothing when undo leads back to what is on the disk', async () => {
    move(1);
    level.undo();
    expect(state()).toEqual({ kind: 'saved' });
    await clock.pass(5000);
    expect(line.writes).toBe(0);
  });

  it('tries again ever more rarely while nobody answers, and at once when the line is back', async () => {
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

  it('writes nothing while it may not, and all of it once it may', async () => {
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

describe('a file that may not be written', () => {
  it('is tried again, and has everything once it may be', async () => {
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

  it('says so before anything is changed, and no longer once it may be', async () => {
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
  it('appears at once where nothing is unsaved, as a step that can be undone', async () => {
    await byOthers((file) => ({ ...file, name: 'theirs' }));
    saver.refresh();
    await breathe();
    expect(level.file().name).toBe('theirs');
    expect(state()).toEqual({ kind: 'saved' });
    level.undo();
    await clock.pass(500);
    expect((await onDisk()).name).toBe('base');
  });

  it('is put together with what is unsaved, and both are written', async () => {
    move(5);
    await byOthers((file) => ({ ...file, name: 'theirs' }));
    saver.refresh();
    await clock.pass(500);
    expect(await onDisk()).toMatchObject({ name: 'theirs', asteroids: [{ x: 15 }] });
    expect(state()).toEqual({ kind: 'saved' });
  });

  it('that nobody told of is found when writing', async () => {
    move(5);
    await byOthers((file) => ({ ...file, name: 'theirs' }));
    await clock.pass(500);
    expect(await onDisk()).toMatchObject({ name: 'theirs', asteroids: [{ x: 15 }] });
    expect(level.file().name).toBe('theirs');
  });

  it('keeps a drag that is going on', async () => {
    const drag = level.begin('Drag');
    drag.set(moveObjects(['aa'], 7, 0));
    await byOthers((file) => ({ ...file, name: 'theirs' }));
    saver.refresh();
    await clock.pass(500);
    expect(await onDisk()).toMatchObject({ name: 'theirs', asteroids: [{ x: 17 }] });
  });

  it('that was read before our own write does not bring the old state back', async () => {
    let open = () => {};
    line.gate = new Promise((resolve) => {
      open = () => resolve();
    });
    move(5);
    await clock.pass(300);
    // an event arrives while our write is on its way
    saver.refresh();
    await breathe();
    line.gate = null;
    open();
    await clock.pass(500);
    expect(level.file().asteroids?.[0].x).toBe(15);
    expect((await onDisk()).asteroids?.[0].x).toBe(15);
  });

  it('that was read before our own write, and told after it, does not either', async () => {
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

  it('that was read while the second of two writes was on its way does not either', async () => {
    const gates: (() => void)[] = [];
    const write = line.write.bind(line);
    line.write = async (...all) => {
      await new Promise<void>((resolve) => gates.push(resolve));
      return write(...all);
    };
    await byOthers((file) => ({ ...file, name: 'theirs' }));
    move(5);
    await clock.pass(300);
    // waits for the first write, which does not fit what is there; the merged level is written at once
    const flushed = saver.flush();
    let openRead = () => {};
    line.readGate = new Promise((resolve) => {
      openRead = () => resolve();
    });
    saver.refresh();
    gates[0]();
    await breathe();
    // what was read before it was written arrives after its answer
    gates[1]();
    await flushed;
    openRead();
    await clock.pass(500);
    expect(level.file().asteroids?.[0].x).toBe(15);
    expect(await onDisk()).toMatchObject({ name: 'theirs', asteroids: [{ x: 15 }] });
  });

  it('of the same thing asks, writes nothing meanwhile, and goes on with what was chosen', async () => {
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

  it('can be taken as it is, or written over', async () => {
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

  it('that takes the level away leaves it in the page; it can be written again', async () => {
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

  it('that is no level is never written over unasked', async () => {
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

  it('is no change by others: what was done after it goes on from there', async () => {
    move(1);
    await mend();
    expect(state()).toEqual({ kind: 'saved' });
    expect((await onDisk()).asteroids?.[0].x).toBe(16);
  });

  it('is not known to be on the disk, nor not to be: taking it back is written', async () => {
    level.undo();
    expect(saver.isUnsaved()).toBe(true);
    line.isCut = false;
    // the server tells what it has as soon as it is there again
    saver.refresh();
    await clock.pass(30_000);
    expect(level.file().asteroids?.[0].x).toBe(10);
    expect((await onDisk()).asteroids?.[0].x).toBe(10);
    expect(state()).toEqual({ kind: 'saved' });
  });

  it('may be an earlier one of several', async () => {
    move(1);
    await clock.pass(30_000);
    move(1);
    await mend();
    expect(state()).toEqual({ kind: 'saved' });
    expect((await onDisk()).asteroids?.[0].x).toBe(17);
  });

  it('and that others have changed elsewhere since is put together with what was done after it', async () => {
    move(1);
    await byOthers((file) => ({ ...file, name: 'theirs' }));
    await mend();
    expect(state()).toEqual({ kind: 'saved' });
    expect(await onDisk()).toMatchObject({ name: 'theirs', asteroids: [{ x: 16 }] });
  });

  it('and that others have changed elsewhere is taken back where it was taken back', async () => {
    level.undo();
    await byOthers((file) => ({ ...file, name: 'theirs' }));
    await mend();
    expect(state()).toEqual({ kind: 'saved' });
    expect(await onDisk()).toMatchObject({ name: 'theirs', asteroids: [{ x: 10 }] });
  });

  it('is known again when others had taken it away and brought it back', async () => {
    await mend();
    line.write = async (id, text, base) => {
      const written = await disk.write(id, text, base);
      if (!written.ok) return written;
      // before the answer the level is moved away, as a checkout does
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

  it('and that others have changed in the same place is asked about', async () => {
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
