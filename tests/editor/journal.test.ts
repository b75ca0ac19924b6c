import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { createEditedLevel, moveObjects, setLevelProperty } from '../../editor/core/document/index.ts';
import { createJournal, createMemoryStore, type JournalStore } from '../../editor/core/journal/index.ts';
import { formatLevel, type LevelFile } from '../../schema/index.ts';
import { FILE, TurnedClock } from './stage.ts';

const clock = () => 1000;

/** A store that fails on demand, and that loses nothing that it has confirmed. */
function unreliable(): JournalStore & { fails: Error | null; writes: number } {
  const store = createMemoryStore();
  return {
    ...store,
    fails: null,
    writes: 0,
    async write(change) {
      this.writes++;
      if (this.fails !== null) throw this.fails;
      await store.write(structuredClone(change));
    },
  };
}

const begin = (store: JournalStore | null = createMemoryStore()) => {
  const journal = createJournal(store, clock);
  const level = createEditedLevel(FILE);
  const base = { file: level.file(), etag: '"1"' };
  return { journal, level, base, kept: journal.follow('07', level, base) };
};
const move = (dx: number) => moveObjects(['aa'], dx, 0);

describe('the journal', () => {
  it('contains every change since the version on disk, after a restart of the page', async () => {
    const store = createMemoryStore();
    const { level, kept } = begin(store);
    level.change('Move', move(1));
    level.change('Rename', setLevelProperty('name', 'new'));
    const drag = level.begin('Drag');
    drag.set(move(100));
    await kept.settled();
    const recovery = await createJournal(store, clock).recover('07');
    expect(recovery).toMatchObject({ labels: ['Move', 'Rename'], lost: 0, time: 1000, base: { etag: '"1"', file: FILE } });
    expect(recovery?.file).toMatchObject({ name: 'new', asteroids: [{ x: 11 }] });
    drag.commit();
    await kept.settled();
    expect((await createJournal(store, clock).recover('07'))?.file.asteroids?.[0].x).toBe(111);
  });

  it('has nothing to recover when everything is on disk, and for a level that was never opened', async () => {
    const store = createMemoryStore();
    const { journal, level, kept } = begin(store);
    await kept.settled();
    expect(await journal.recover('07')).toBeNull();
    expect(await journal.recover('08')).toBeNull();
    level.change('Move', move(1));
    const saved = level.file();
    kept.onDisk(saved, '"2"');
    await kept.settled();
    expect(await journal.recover('07')).toBeNull();
    expect(await journal.unsaved()).toEqual([]);
  });

  it('keeps changes that are made during a save', async () => {
    const store = createMemoryStore();
    const { journal, level, kept } = begin(store);
    level.change('Move', move(1));
    const saved = level.file();
    level.change('Move again', move(10));
    await kept.settled();
    kept.onDisk(saved, '"2"');
    await kept.settled();
    expect(await journal.recover('07')).toMatchObject({
      labels: ['Move again'],
      base: { etag: '"2"', file: { asteroids: [{ x: 11 }] } },
      file: { asteroids: [{ x: 21 }] },
    });
    expect(await journal.unsaved()).toEqual([{ place: '07', time: 1000 }]);
  });

  it('contains the level and the new base after a merge', async () => {
    const store = createMemoryStore();
    const { journal, level, kept } = begin(store);
    level.change('Move', move(1));
    const theirs = { ...FILE, description: 'theirs' };
    level.replace('Merged', { ...level.file(), description: 'theirs' });
    kept.onDisk(theirs, '"9"');
    level.change('Move', move(1));
    await kept.settled();
    expect(await journal.recover('07')).toMatchObject({
      base: { etag: '"9"', file: theirs },
      file: { description: 'theirs', asteroids: [{ x: 12 }] },
    });
  });

  it('knows every state that may have been written, folded or not, until one is known to be on disk', async () => {
    const store = createMemoryStore();
    const { journal, level, kept } = begin(store);
    const places = async () => (await journal.recover('07'))?.base.sent.map(({ asteroids }) => asteroids?.[0].x);
    level.change('Move', move(1));
    level.change('Move', move(1));
    kept.onSent(level.file());
    await kept.settled();
    expect(await places()).toEqual([11, 12]);
    for (let i = 0; i < 250; i++) level.change('Move', move(1));
    await kept.settled();
    const folded = await places();
    expect(folded).toContain(12);
    expect(folded?.length).toBeLessThan(210);
    kept.onDisk(level.file(), '"2"');
    level.change('Move', move(1));
    await kept.settled();
    expect(await places()).toEqual([263]);
  });

  it('reports when it has stored what is sent to the disk, or that it failed', async () => {
    const gates: (() => void)[] = [];
    const slow = createMemoryStore();
    const store: JournalStore = {
      ...slow,
      async write(change) {
        await new Promise<void>((resolve) => gates.push(resolve));
        if (change.add.some(({ label }) => label === 'Fails')) throw new Error('no');
        await slow.write(change);
      },
    };
    const { level, kept } = begin(store);
    const open = async () => {
      gates.shift()?.();
      await new Promise((resolve) => setImmediate(resolve));
    };
    const said: string[] = [];
    await open();
    level.change('Move', move(1));
    void kept.onSent(level.file()).then(() => said.push('first'));
    level.change('Move', move(1));
    await open();
    expect(said).toEqual(['first']);
    void kept.onSent(level.file()).then(() => said.push('second'));
    level.change('Fails', move(1));
    void kept.onSent(level.file()).then(() => said.push('failed'));
    await open();
    expect(said).toEqual(['first', 'second']);
    // everything that failed is tried again together
    await open();
    expect(said).toEqual(['first', 'second']);
    await open();
    expect(said).toEqual(['first', 'second', 'failed']);
    await kept.onSent(level.file());
  });

  it('sends every step immediately, and reports it as kept only when all earlier ones are', async () => {
    const gates: (() => void)[] = [];
    const slow = createMemoryStore();
    const sent: number[] = [];
    const store: JournalStore = {
      ...slow,
      async write(change) {
        sent.push(change.add.length);
        await new Promise<void>((resolve) => gates.push(resolve));
        await slow.write(change);
      },
    };
    const { level, kept } = begin(store);
    const open = async () => {
      gates.shift()?.();
      await new Promise((resolve) => setImmediate(resolve));
    };
    await open();
    expect(kept.keeping.getState()).toBe('kept');
    for (let i = 0; i < 3; i++) {
      level.change('Move', move(1));
      expect(kept.keeping.getState()).toBe('keeping');
    }
    expect(sent).toEqual([0, 1, 1, 1]);
    await open();
    await open();
    expect(kept.keeping.getState()).toBe('keeping');
    await open();
    expect(kept.keeping.getState()).toBe('kept');
    // but not without limit: a database that hangs does not get more and more
    for (let i = 0; i < 100; i++) level.change('Move', move(1));
    expect(sent.length).toBeLessThan(20);
    for (let i = 0; i < 20; i++) await open();
    expect(kept.keeping.getState()).toBe('kept');
    expect((await slow.read('07'))?.entries).toHaveLength(103);
  });

  it('retries automatically after a failure, and reports only stored steps as kept', async () => {
    const store = unreliable();
    const clock = new TurnedClock();
    const journal = createJournal(store, () => 1000, clock.after.bind(clock));
    const level = createEditedLevel(FILE);
    const kept = journal.follow('07', level, { file: level.file(), etag: '"1"' });
    await kept.settled();
    store.fails = new Error('disk');
    level.change('Move', move(1));
    await kept.settled();
    expect([kept.keeping.getState(), journal.state.getState().kind]).toEqual(['failing', 'failing']);
    await clock.pass(60_000);
    expect(kept.keeping.getState()).toBe('failing');
    store.fails = null;
    await clock.pass(60_000);
    expect([kept.keeping.getState(), journal.state.getState().kind]).toEqual(['kept', 'working']);
    expect((await journal.recover('07'))?.file.asteroids?.[0].x).toBe(11);
    store.fails = new Error('disk');
    level.change('Move', move(1));
    await kept.settled();
    kept.close();
    const { writes } = store;
    await clock.pass(60_000);
    expect(store.writes).toBe(writes);
  });

  it('stores everything again if its data are cleared', async () => {
    const store = createMemoryStore();
    // as a recreated database does
    const cleared: JournalStore = {
      ...store,
      async write(change) {
        if (change.base === undefined && (await store.read(change.place)) === null)
          throw new DOMException('gone', 'NotFoundError');
        await store.write(change);
      },
    };
    const { level, kept } = begin(cleared);
    level.change('Move', move(1));
    await kept.settled();
    await store.remove('07');
    level.change('Move', move(1));
    level.change('Move', move(1));
    await kept.settled();
    expect(kept.keeping.getState()).toBe('kept');
    expect(await createJournal(store, () => 1).recover('07')).toMatchObject({ file: { asteroids: [{ x: 13 }] }, lost: 0 });
  });

  it('switches to a database that answers late, and reports its state until then', async () => {
    const { journal, level, kept } = begin(null);
    level.change('Move', move(1));
    await kept.settled();
    expect(kept.keeping.getState()).toBe('page');
    const store = createMemoryStore();
    let times = 0;
    journal.onAdopted(() => times++);
    journal.adopt(store);
    journal.adopt(createMemoryStore());
    expect([times, journal.state.getState().kind]).toEqual([1, 'working']);
    // its callers have to follow their levels again
    expect(await journal.recover('07')).toBeNull();
    kept.close();
    const again = journal.follow('07', level, { file: FILE, etag: '"1"' });
    await again.settled();
    expect(again.keeping.getState()).toBe('kept');
    expect((await createJournal(store, () => 1).recover('07'))?.file.asteroids?.[0].x).toBe(11);
  });

  it('keeps recovered changes until they are on disk, even if the page dies again at once', async () => {
    const store = createMemoryStore();
    const { level, kept, base } = begin(store);
    level.change('Move', move(1));
    await kept.settled();
    const journal = createJournal(store, clock);
    const recovery = await journal.recover('07');
    const again = createEditedLevel(base.file);
    again.replace('Recovered', recovery?.file ?? base.file);
    await journal.follow('07', again, base).settled();
    expect((await createJournal(store, clock).recover('07'))?.file.asteroids?.[0].x).toBe(11);
  });

  it('recovers everything that was kept, at whatever moment the page dies', async () => {
    await fc.assert(
      fc.asyncProperty(
        fc.array(fc.oneof(fc.constantFrom('change', 'undo', 'redo', 'save', 'wait', 'fail', 'mend'), fc.constant('change')), {
          maxLength: 30,
        }),
        async (acts) => {
          const store = unreliable();
          const { level, kept } = begin(store);
          let disk = level.file();
          let n = 0;
          for (const act of acts) {
            if (act === 'change') level.change(`step ${++n}`, move(n));
            else if (act === 'undo') level.undo();
            else if (act === 'redo') level.redo();
            else if (act === 'wait') await kept.settled();
            else if (act === 'fail') store.fails = new Error('disk');
            else if (act === 'mend') store.fails = null;
            else {
              disk = level.file();
              kept.onDisk(disk, `"${n}"`);
            }
          }
          store.fails = null;
          // one more change stores everything that failed before
          level.change('last', move(1000));
          await kept.settled();
          const recovery = await createJournal(store, clock).recover('07');
          expect(formatLevel(recovery?.file as LevelFile)).toBe(formatLevel(level.file()));
          expect(formatLevel(recovery?.base.file as LevelFile)).toBe(formatLevel(disk));
          expect(recovery?.lost).toBe(0);
        },
      ),
      { numRuns: 120 },
    );
  });

  it('stays small: many steps are folded into one text', async () => {
    const store = createMemoryStore();
    const { level, kept } = begin(store);
    for (let i = 0; i < 1000; i++) level.change('Move', move(1));
    await kept.settled();
    expect((await store.read('07'))?.entries.length).toBeLessThanOrEqual(200);
    expect((await createJournal(store, clock).recover('07'))?.file.asteroids?.[0].x).toBe(1010);
  });

  it('makes space by deleting what is on disk anyway, and reports if that does not help', async () => {
    const store = unreliable();
    const other = createJournal(store, clock).follow('01', createEditedLevel(FILE), { file: FILE, etag: '"1"' });
    await other.settled();
    const { journal, level, kept } = begin(store);
    await kept.settled();
    store.fails = Object.assign(new Error('full'), { name: 'QuotaExceededError' });
    level.change('Move', move(1));
    await kept.settled();
    expect(await store.read('01')).toBeNull();
    expect(journal.state.getState()).toMatchObject({ kind: 'failing', message: expect.stringContaining('no room') });
    store.fails = null;
    level.change('Move', move(1));
    await kept.settled();
    expect(journal.state.getState()).toEqual({ kind: 'working' });
    expect((await journal.recover('07'))?.file.asteroids?.[0].x).toBe(12);
  });

  it('reports that nothing is kept if the browser has no database, and continues', async () => {
    const { journal, level, kept } = begin(null);
    level.change('Move', move(1));
    await kept.settled();
    expect(journal.state.getState()).toMatchObject({ kind: 'missing' });
    expect((await journal.recover('07'))?.labels).toEqual(['Move']);
  });

  it('recovers what it can from a damaged journal, and reports how much was lost', async () => {
    const store = createMemoryStore();
    const { journal, level, kept } = begin(store);
    level.change('one', move(1));
    await kept.settled();
    await store.write({
      place: '07',
      time: 1,
      add: [
        { number: 2, label: 'bad', patches: [{ op: 'replace', path: ['novae', 7, 'x'], value: 1 }] },
        { number: 3, label: 'after', patches: [] },
      ],
    });
    expect(await journal.recover('07')).toMatchObject({ labels: ['one'], lost: 2, file: { asteroids: [{ x: 11 }] } });
  });
});
