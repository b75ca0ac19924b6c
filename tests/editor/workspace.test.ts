import { beforeEach, describe, expect, it } from 'vitest';
import { setLevelProperty } from '../../editor/core/document/index.ts';
import {
  type Answer,
  createBrowserStorage,
  createWorkspace,
  type LevelStorage,
  type OpenedLevel,
  type Workspace,
} from '../../editor/core/files/index.ts';
import { storageError } from '../../editor/core/files/level-storage.ts';
import { createJournal, createMemoryStore, type JournalStore } from '../../editor/core/journal/index.ts';
import { formatLevel, type LevelEntry, type LevelFile, type Problem } from '../../schema/index.ts';
import { breathe, createChannels, createKeyValues, createLine, LockKeeper, passingVersions, TurnedClock } from './stage.ts';

const fileOf = (name: string): LevelFile => ({ version: 1, name, astronaut: { x: 0, y: 0 }, blackHole: { x: 300, y: 0 } });

let clock: TurnedClock;
let disk: LevelStorage;
let locks: LockKeeper;
let channel: ReturnType<typeof createChannels>;
let store: JournalStore;
let pages = 0;

async function page(journal = createJournal(store, () => 0)) {
  const line = createLine(disk);
  let reads = 0;
  const { read } = line;
  line.read = (id) => {
    reads++;
    return read.call(line, id);
  };
  const workspace = createWorkspace({
    ...{ storage: line, journal, versions: passingVersions(), timers: clock, channel, locks: locks.of(`page ${pages++}`) },
  });
  await workspace.start();
  return { line, workspace, reads: () => reads, journal };
}

beforeEach(async () => {
  clock = new TurnedClock();
  locks = new LockKeeper();
  channel = createChannels();
  store = createMemoryStore();
  disk = createBrowserStorage(createKeyValues(), null, () => 0);
  for (const id of ['a', 'b', 'c']) await disk.write(id, formatLevel(fileOf(id)), null);
});

const opened = (workspace: Workspace) => workspace.store.getState().opened as OpenedLevel;
const open = async (workspace: Workspace, id: string) => {
  await workspace.open(id);
  return opened(workspace);
};
const rename = (one: OpenedLevel, name: string) => one.level.change('Rename', setLevelProperty('name', name));
const ids = (workspace: Workspace) => workspace.store.getState().list?.levels.map(({ id }) => id);
const entry = (workspace: Workspace, id: string) =>
  workspace.store.getState().list?.levels.find((level) => level.id === id) as LevelEntry;
const read = async (id: string) => {
  const answer = await disk.read(id);
  return answer.ok ? answer.value : null;
};
const nameOnDisk = async (id: string) => (await read(id))?.name;
const granted = <T>(answer: Answer<T>): T => {
  if (!answer.ok) throw new Error(answer.error.message);
  return answer.value;
};
/** Another program writes, and the page gets an event. */
const byOthers = async (line: ReturnType<typeof createLine>, id: string, name: string) => {
  const written = await disk.write(id, formatLevel(fileOf(name)), (await read(id))?.etag ?? null);
  line.tell({ type: 'changed', entry: granted(written), by: null });
  await breathe();
};

describe('the list', () => {
  it('is requested at the start, and an error is shown until it arrives', async () => {
    const { workspace, line } = await page();
    expect(workspace.store.getState()).toMatchObject({ error: null, link: 'up', opened: null, refused: null });
    expect(ids(workspace)).toEqual(['a', 'b', 'c']);
    line.isCut = true;
    await workspace.refresh();
    expect(workspace.store.getState()).toMatchObject({ error: { code: 'unreachable' } });
    expect(ids(workspace)).toEqual(['a', 'b', 'c']);
    line.isCut = false;
    await workspace.refresh();
    expect(workspace.store.getState().error).toBeNull();
    line.link('gone');
    expect(workspace.store.getState().link).toBe('gone');
  });

  it('shows changed levels in place, new ones where the storage has them, and deleted ones no more', async () => {
    const { workspace, line } = await page();
    let lists = 0;
    const { list } = line;
    line.list = () => {
      lists++;
      return list.call(line);
    };
    await byOthers(line, 'b', 'B');
    expect(workspace.store.getState().list?.levels.map(({ name }) => name)).toEqual(['a', 'B', 'c']);
    expect(lists).toBe(0);
    const made = granted(await disk.write('0', formatLevel(fileOf('new')), null));
    await disk.order('', ['0', 'a', 'b', 'c']);
    line.tell({ type: 'changed', entry: made, by: null });
    // first at the end, then at its place
    expect(ids(workspace)).toEqual(['a', 'b', 'c', '0']);
    await breathe();
    expect([ids(workspace), lists]).toEqual([['0', 'a', 'b', 'c'], 1]);
    line.tell({ type: 'removed', id: 'b', by: null });
    expect(ids(workspace)).toEqual(['0', 'a', 'c']);
    const renamed = granted(await disk.rename('a', 'z', (await read('a'))?.etag ?? ''));
    line.tell({ type: 'renamed', from: 'a', entry: renamed, by: null });
    expect(ids(workspace)).toEqual(['0', 'z', 'c']);
    await breathe();
    expect([ids(workspace), lists]).toEqual([['0', 'z', 'b', 'c'], 2]);
  });

  it('keeps a renamed level at its place while pack.json still has its old id, and follows it once it has the new one', async () => {
    const { workspace } = await page();
    const packOf = (levels: string[]) => `${JSON.stringify({ version: 1, name: 'pack', levels }, null, 2)}\n`;
    granted(await workspace.writePack(packOf(['c', 'a', 'b'])));
    expect(ids(workspace)).toEqual(['c', 'a', 'b']);
    granted(await workspace.rename(entry(workspace, 'a'), 'z'));
    granted(await workspace.rename(entry(workspace, 'c'), 'y'));
    granted(await workspace.rename(entry(workspace, 'z'), 'x'));
    expect(ids(workspace)).toEqual(['y', 'x', 'b']);
    granted(await workspace.writePack(packOf(['b', 'x', 'y'])));
    expect(ids(workspace)).toEqual(['b', 'x', 'y']);
  });

  it('ignores events before it has arrived', async () => {
    const { workspace, line } = await page();
    workspace.store.setState({ list: null });
    line.tell({ type: 'read', levels: [], unread: 0 });
    line.tell({ type: 'removed', id: 'b', by: null });
    expect(workspace.store.getState().list).toBeNull();
    const list = granted(await disk.list());
    line.tell({ type: 'list', list: { ...list, levels: list.levels.slice(0, 1), unread: 2 } });
    expect(ids(workspace)).toEqual(['a']);
    workspace.store.setState({ list: null });
    line.tell({ type: 'changed', entry: granted(await disk.read('a')), by: null });
    expect(workspace.store.getState().list).toBeNull();
  });

  it('informs the open level about its own events only', async () => {
    const { workspace, line, reads } = await page();
    const one = await open(workspace, 'a');
    const before = reads();
    await byOthers(line, 'b', 'B');
    line.tell({ type: 'removed', id: 'c', by: null });
    line.tell({ type: 'list', list: granted(await disk.list()) });
    await breathe();
    // a known version is not read again
    expect(reads()).toBe(before);
    await byOthers(line, 'a', 'A');
    expect(one.level.file().name).toBe('A');
    await disk.write('a', formatLevel(fileOf('AA')), (await read('a'))?.etag ?? '');
    line.tell({ type: 'list', list: granted(await disk.list()) });
    await breathe();
    expect(one.level.file().name).toBe('AA');
    // while a list arrives in parts, a missing level is not a deleted one
    const whole = granted(await disk.list());
    await disk.remove('a', (await read('a'))?.etag ?? '');
    line.tell({ type: 'list', list: { ...whole, levels: whole.levels.slice(1), unread: 1 } });
    await breathe();
    expect(one.saver.store.getState().kind).toBe('saved');
    line.tell({ type: 'read', levels: [], unread: 0 });
    await breathe();
    expect(one.saver.store.getState()).toMatchObject({ kind: 'deleted' });
  });

  it('informs it about its deletion, and about the restored connection', async () => {
    const { workspace, line } = await page();
    const one = await open(workspace, 'a');
    line.isCut = true;
    rename(one, 'mine');
    await clock.pass(1000);
    expect(one.saver.store.getState().kind).toBe('offline');
    line.isCut = false;
    line.link('gone');
    await clock.pass(1);
    expect(one.saver.store.getState().kind).toBe('offline');
    line.link('up');
    await clock.pass(1);
    expect(one.saver.store.getState().kind).toBe('saved');
    await disk.remove('a', (await read('a'))?.etag ?? '');
    line.tell({ type: 'removed', id: 'a', by: null });
    await breathe();
    expect(one.saver.store.getState()).toMatchObject({ kind: 'deleted' });
  });
});

describe('the open level', () => {
  it('is written when another is opened, when it is left and when the page is closed, including a drag in progress', async () => {
    const { workspace } = await page();
    const leaving: [string, () => Promise<unknown>][] = [
      ['b', () => workspace.open('a')],
      ['c', () => workspace.leave()],
      ['a', () => workspace.close()],
    ];
    for (const [id, leave] of leaving) {
      const one = await open(workspace, id);
      const drag = one.level.begin('Drag');
      drag.set(setLevelProperty('name', `${id} dragged`));
      await leave();
      expect(await nameOnDisk(id)).toBe(`${id} dragged`);
    }
    expect(workspace.store.getState().opened).toBeNull();
    await workspace.leave();
  });

  it('is shown once it is known whether this page may write it', async () => {
    let go = () => {};
    const gate = new Promise<void>((resolve) => {
      go = resolve;
    });
    const mine = locks.of('slow');
    const request = (...all: [never, never, never]) => gate.then(() => mine.request(...all));
    const line = createLine(disk);
    const workspace = createWorkspace({
      ...{
        storage: line,
        journal: createJournal(store, () => 0),
        versions: passingVersions(),
        timers: clock,
        channel,
        locks: { request: request as never },
      },
    });
    await workspace.start();
    const opening = workspace.open('a');
    await clock.pass(60_000);
    expect(workspace.store.getState().opened).toBeNull();
    go();
    await opening;
    expect(opened(workspace).lock.store.getState()).toBe('writer');
    expect(opened(workspace).saver.store.getState()).toEqual({ kind: 'saved' });
  });

  it('is read-only if another page has taken it in the meantime', async () => {
    let go = () => {};
    let gate = new Promise<void>((resolve) => {
      go = resolve;
    });
    const journal = createJournal(store, () => 0);
    const fails = () => Promise.reject(new Error('it does not answer'));
    for (const [id, recover] of [
      ['a', journal.recover],
      ['b', fails],
    ] as const) {
      const one = await page({ ...journal, recover: (place) => gate.then(() => recover(place)) });
      const two = await page();
      const opening = one.workspace.open(id);
      await breathe();
      const other = await open(two.workspace, id);
      other.lock.takeOver();
      await clock.pass(5000);
      expect(other.lock.store.getState()).toBe('writer');
      go();
      await opening;
      const mine = opened(one.workspace);
      await clock.pass(10_000);
      expect([mine.lock.store.getState(), mine.saver.store.getState().kind, mine.keeping.getState()]).toEqual([
        'reader',
        'readOnly',
        null,
      ]);
      gate = new Promise<void>((resolve) => {
        go = resolve;
      });
    }
  });

  it('stays on the screen until the next one is ready, and can be opened again', async () => {
    const { workspace, line } = await page();
    const first = await open(workspace, 'a');
    let go = () => {};
    line.readGate = new Promise((resolve) => {
      go = () => resolve();
    });
    const opening = workspace.open('b');
    await breathe();
    expect(opened(workspace)).toBe(first);
    go();
    await opening;
    const second = opened(workspace);
    expect(second.id()).toBe('b');
    // two requests at the same time are handled one after the other
    await Promise.all([workspace.open('b'), workspace.open('b')]);
    expect(opened(workspace).id()).toBe('b');
    expect(opened(workspace)).not.toBe(second);
    expect(opened(workspace).lock.store.getState()).toBe('writer');
    // the lock of the first level is free
    const other = await page();
    expect((await open(other.workspace, 'a')).lock.store.getState()).toBe('writer');
  });

  it('can not be an unreadable or invalid file, and an error disappears when another level is opened', async () => {
    const { workspace, line } = await page();
    await open(workspace, 'a');
    expect(await workspace.open('nowhere')).toMatchObject({ ok: false, kind: 'failed', error: { code: 'unknown-level' } });
    expect(workspace.store.getState()).toMatchObject({ opened: null, refused: { id: 'nowhere' } });
    // an unreadable file has no text, and the storage gives the reason
    const why: Problem = {
      ...{
        code: 'unreadable-file',
        severity: 'error',
        message: 'denied',
        hint: 'Allow it.',
        pointer: '',
        line: null,
        column: null,
      },
    };
    for (const [text, code] of [
      [null, 'unreadable-file'],
      ['{', 'truncated-json'],
    ] as const) {
      const { read } = line;
      line.read = async (id) => {
        const answer = await read(id);
        return answer.ok ? { ...answer, value: { ...answer.value, text, etag: '"e"', problems: [why] } } : answer;
      };
      const opening = await workspace.open('b');
      expect(opening).toMatchObject({ ok: false, kind: 'invalid', text: text ?? '', etag: '"e"', problems: [{ code }] });
      line.read = read;
    }
    await open(workspace, 'c');
    expect(workspace.store.getState().refused).toBeNull();
  });

  it('keeps its history until somebody else changes it', async () => {
    const { workspace } = await page();
    const labels = async (id: string) => (await open(workspace, id)).level.labels();
    rename(await open(workspace, 'a'), 'A');
    expect(await labels('b')).toEqual([]);
    expect(await labels('a')).toEqual(['Rename']);
    await workspace.leave();
    await disk.write('a', formatLevel(fileOf('theirs')), (await read('a'))?.etag ?? '');
    expect(await labels('a')).toEqual([]);
    expect(opened(workspace).level.file().name).toBe('theirs');
  });

  it('follows a rename, as do the histories of others, even if two levels swap names', async () => {
    const { workspace, line } = await page();
    rename(await open(workspace, 'b'), 'B');
    rename(await open(workspace, 'a'), 'A');
    await workspace.refresh();
    granted(await workspace.rename(entry(workspace, 'b'), 'd'));
    expect(opened(workspace).id()).toBe('a');
    granted(await workspace.rename(entry(workspace, 'a'), 'b'));
    expect(opened(workspace).id()).toBe('b');
    expect(await nameOnDisk('b')).toBe('A');
    expect((await open(workspace, 'd')).level.labels()).toEqual(['Rename']);
    expect((await open(workspace, 'b')).level.labels()).toEqual(['Rename']);
    // renames by other programs are reported one by one
    const away = granted(await disk.rename('b', 'e', (await read('b'))?.etag ?? ''));
    line.tell({ type: 'renamed', from: 'b', entry: away, by: null });
    await breathe();
    expect(opened(workspace).id()).toBe('e');
    rename(opened(workspace), 'E');
    await clock.pass(500);
    expect(await nameOnDisk('e')).toBe('E');
    // nothing is remembered for a name that is free again
    await disk.write('b', formatLevel(fileOf('E')), null);
    expect((await open(workspace, 'b')).level.labels()).toEqual([]);
  });

  it('is renamed together with the others when levels are reordered', async () => {
    const { workspace, line } = await page();
    rename(await open(workspace, 'b'), 'B');
    await open(workspace, 'a');
    rename(opened(workspace), 'A');
    line.order = async () => {
      // two files swap places
      const [a, b] = [await read('a'), await read('b')];
      await disk.rename('a', 'x', a?.etag ?? '');
      const toA = granted(await disk.rename('b', 'a', b?.etag ?? ''));
      const toB = granted(await disk.rename('x', 'b', a?.etag ?? ''));
      const levels = [toA, toB, entry(workspace, 'c')];
      return {
        ok: true,
        value: {
          renamed: [
            { from: 'a', to: 'b' },
            { from: 'b', to: 'a' },
          ],
          levels,
        },
      };
    };
    const ordering = workspace.order('', ['b', 'a']);
    await breathe();
    await ordering;
    expect(opened(workspace).id()).toBe('b');
    expect([await nameOnDisk('a'), await nameOnDisk('b')]).toEqual(['B', 'A']);
    expect((await open(workspace, 'a')).level.labels()).toEqual(['Rename']);
    expect((await open(workspace, 'b')).level.labels()).toEqual(['Rename']);
  });

  it('is shown at its new place at once, before the storage answers; other folders are not affected', async () => {
    const { workspace, line } = await page();
    let go = () => {};
    const gate = new Promise<void>((resolve) => {
      go = resolve;
    });
    line.order = async () => {
      await gate;
      return { ok: false, error: storageError('list-changed', 'no', 'look') };
    };
    const ordering = workspace.order('', ['c', 'a', 'nowhere']);
    await breathe();
    expect(ids(workspace)).toEqual(['c', 'b', 'a']);
    go();
    expect(await ordering).toMatchObject({ ok: false });
    expect(ids(workspace)).toEqual(['a', 'b', 'c']);
  });

  it('is written before it is copied, renamed, deleted or reordered; others are used as listed', async () => {
    const { workspace, line } = await page();
    const one = await open(workspace, 'a');
    rename(one, 'one');
    expect(await workspace.duplicate(entry(workspace, 'a'), 'copy')).toMatchObject({ ok: true, value: { name: 'one' } });
    rename(one, 'two');
    await workspace.order('', ['a', 'b', 'c', 'copy']);
    expect(await nameOnDisk('a')).toBe('two');
    rename(one, 'three');
    expect(await workspace.remove(entry(workspace, 'a'))).toMatchObject({ ok: true });
    const { trash } = granted(await workspace.storage.trash())[0];
    expect(await workspace.restore(trash, 'back')).toMatchObject({ ok: true, value: { id: 'back', name: 'three' } });
    expect(ids(workspace)).toEqual(['b', 'c', 'copy', 'back']);
    expect(await workspace.rename(entry(workspace, 'b'), 'c')).toMatchObject({ ok: false, error: { code: 'name-taken' } });
    // and its history stays
    rename(await open(workspace, 'b'), 'changed');
    await open(workspace, 'c');
    await workspace.refresh();
    expect(await workspace.rename(entry(workspace, 'b'), 'c')).toMatchObject({ ok: false, error: { code: 'name-taken' } });
    expect((await open(workspace, 'b')).level.labels()).toEqual(['Rename']);
    await workspace.leave();
    // an unreadable level has no etag, and is refused
    expect(await workspace.remove({ ...entry(workspace, 'b'), etag: null })).toMatchObject({
      ok: false,
      error: { code: 'conflict' },
    });
    // errors that are not about the list do not request it again
    line.duplicate = async () => ({ ok: false, error: storageError('disk-full', 'full', 'make room') });
    line.isCut = true;
    await workspace.duplicate(entry(workspace, 'b'), 'x');
    expect(workspace.store.getState().error).toBeNull();
  });
});

describe('the journal of the open level', () => {
  it('reports its state, or null if another page keeps it', async () => {
    const [one, two] = [await page(), await page()];
    const a = await open(one.workspace, 'a');
    const b = await open(two.workspace, 'a');
    await breathe();
    expect([a.keeping.getState(), b.keeping.getState()]).toEqual(['kept', null]);
    const said: unknown[] = [];
    a.keeping.subscribe((keeping) => said.push(keeping));
    rename(a, 'more');
    expect(a.keeping.getState()).toBe('keeping');
    await breathe();
    expect(said).toEqual(['keeping', 'kept']);
    b.lock.takeOver();
    await breathe();
    await breathe();
    expect([a.keeping.getState(), b.keeping.getState()]).toEqual([null, 'kept']);
    // after a rename, a reader is still a reader
    a.moved('z', '"e"');
    expect([a.id(), a.keeping.getState()]).toEqual(['z', null]);
  });

  it('moves to the new name when the level is renamed', async () => {
    const { workspace, line } = await page();
    const one = await open(workspace, 'a');
    granted(await workspace.rename(entry(workspace, 'a'), 'z'));
    line.isCut = true;
    rename(one, 'unsaved');
    await clock.pass(1000);
    const places = (await store.places()).map(({ place }) => place);
    expect(places).toEqual(['this-browser/z']);
    expect(await createJournal(store, () => 0).recover('this-browser/z')).toMatchObject({ labels: ['Rename'] });
    expect(one.keeping.getState()).toBe('kept');
  });

  it('keeps unsaved changes when the level is renamed and gets its old name back at once', async () => {
    const { workspace, line } = await page();
    const one = await open(workspace, 'a');
    await breathe();
    line.isCut = true;
    rename(one, 'unsaved');
    const etag = (await read('a'))?.etag ?? '';
    one.moved('z', etag);
    one.moved('a', etag);
    await clock.pass(1000);
    expect((await store.places()).map(({ place }) => place)).toEqual(['this-browser/a']);
    expect(await createJournal(store, () => 0).recover('this-browser/a')).toMatchObject({ file: { name: 'unsaved' } });
  });

  it('reports nothing after the level is closed', async () => {
    const { workspace, line } = await page();
    const one = await open(workspace, 'a');
    line.isCut = true;
    rename(one, 'unsaved');
    await workspace.leave();
    expect(one.keeping.getState()).toBeNull();
    rename(one, 'later');
    await breathe();
    expect(await createJournal(store, () => 0).recover('this-browser/a')).toMatchObject({
      labels: ['Rename'],
      file: { name: 'unsaved' },
    });
    line.isCut = false;
    const again = await open(workspace, 'a');
    expect(again.recovered).toMatchObject({ labels: ['Rename'] });
  });
});
