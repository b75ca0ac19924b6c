import fc from 'fast-check';
import { beforeEach, describe, expect, it } from 'vitest';
import { createStore } from 'zustand/vanilla';
import { addChapter, moveEntries } from '../../check/pack/index.ts';
import type { Editor, OpenLevel } from '../../editor/core/context/index.ts';
import {
  createBrowserStorage,
  createOpeningMarks,
  createWorkspace,
  folderPackIn,
  type LevelStorage,
  type Workspace,
} from '../../editor/core/files/index.ts';
import { createJournal, createMemoryStore } from '../../editor/core/journal/index.ts';
import { addLevels, deleteLevel, duplicateLevel, restoreLevel } from '../../editor/core/levels/level-files.ts';
import { listHistoryOf } from '../../editor/core/levels/list-history.ts';
import { editPack } from '../../editor/core/levels/pack-steps.ts';
import { createNotices } from '../../editor/core/notices/index.ts';
import { moveTo } from '../../editor/features/levels/level-rows.ts';
import { formatLevel, formatPack, type LevelEntry, type LevelFile, type PackFile } from '../../schema/index.ts';
import { breathe, createChannels, createKeyValues, createLine, LockKeeper, passingVersions, TurnedClock } from './stage.ts';

const fileOf = (name: string): LevelFile => ({ version: 1, name, astronaut: { x: 0, y: 0 }, blackHole: { x: 300, y: 0 } });
const packOf = (...levels: PackFile['levels']): PackFile => ({ version: 1, name: 'Test', levels });

let editor: Editor;
let workspace: Workspace;
let disk: LevelStorage;
let line: ReturnType<typeof createLine>;

async function start(ids: readonly string[] = ['a', 'b', 'c']): Promise<void> {
  disk = createBrowserStorage(createKeyValues(), null, () => 0);
  for (const id of ids) await disk.write(id, formatLevel(fileOf(id)), null);
  line = createLine(disk);
  workspace = createWorkspace({
    ...{
      storage: line,
      journal: createJournal(createMemoryStore(), () => 0),
      versions: passingVersions(),
      timers: new TurnedClock(),
    },
    ...{ channel: createChannels(), locks: new LockKeeper().of('page') },
  });
  await workspace.start();
  const parts: Partial<Editor> = {
    ...{ workspace, notices: createNotices(), marks: createOpeningMarks(null, 'tab') },
    open: createStore<OpenLevel | null>(() => null),
  };
  editor = parts as Editor;
}

beforeEach(() => start());

const levels = () => workspace.store.getState().list?.levels ?? [];
const ids = () => levels().map(({ id }) => id);
const entry = (id: string) => levels().find((level) => level.id === id) as LevelEntry;
const textOnDisk = async () => {
  const list = await disk.list();
  return list.ok ? (list.value.pack?.text ?? null) : null;
};
const entries = () => {
  const pack = folderPackIn(workspace.store.getState());
  return pack.kind === 'valid' ? pack.reading.pack.levels : null;
};
const write = async (pack: PackFile) => {
  const answer = await workspace.writePack(formatPack(pack));
  if (!answer.ok) throw new Error(answer.error.message);
};
/** Another program writes, and the page does not know yet. */
const writeByOthers = async (pack: PackFile | null) => {
  const list = await disk.list();
  const base = list.ok ? (list.value.pack?.etag ?? null) : null;
  await disk.writePack(pack === null ? null : formatPack(pack), base);
};
const undo = async () => {
  listHistoryOf(editor).undo();
  await breathe();
};
const redo = async () => {
  listHistoryOf(editor).redo();
  await breathe();
};
const warnings = () => editor.notices.store.getState().filter(({ severity }) => severity !== 'info');

describe('the list of levels', () => {
  it('follows pack.json, and changes of it by others', async () => {
    await write(packOf('c', 'a'));
    expect(ids()).toEqual(['c', 'a', 'b']);
    await writeByOthers(packOf('b', 'c', 'a'));
    const list = await disk.list();
    line.tell({ type: 'pack', pack: (list.ok && list.value.pack) || null, by: null });
    expect(ids()).toEqual(['b', 'c', 'a']);
    await writeByOthers(null);
    line.tell({ type: 'pack', pack: null, by: null });
    await breathe();
    expect(ids()).toEqual(['a', 'b', 'c']);
  });

  it('is reordered in pack.json, and no file gets another name', async () => {
    await write(packOf('b', { chapter: 'C' }, 'a', 'c'));
    moveTo(editor, levels(), entry('c'), 0);
    await breathe();
    expect(entries()).toEqual(['c', 'b', { chapter: 'C' }, 'a']);
    expect(ids()).toEqual(['c', 'b', 'a']);
    moveTo(editor, levels(), entry('c'), 1);
    await breathe();
    expect(entries()).toEqual(['b', 'c', { chapter: 'C' }, 'a']);
    await undo();
    await undo();
    expect(entries()).toEqual(['b', { chapter: 'C' }, 'a', 'c']);
    expect(warnings()).toEqual([]);
  });

  it('lists an unlisted level, and those above it, when it is moved', async () => {
    await write(packOf('b'));
    expect(ids()).toEqual(['b', 'a', 'c']);
    moveTo(editor, levels(), entry('c'), 1);
    await breathe();
    expect([entries(), ids()]).toEqual([
      ['b', 'c'],
      ['b', 'c', 'a'],
    ]);
    await undo();
    expect(entries()).toEqual(['b']);
    moveTo(editor, levels(), entry('a'), 2);
    await breathe();
    expect(entries()).toEqual(['b', 'c', 'a']);
  });
});

describe('levels and their order', () => {
  it('change together: new, copied, deleted and restored levels', async () => {
    await write(packOf('c', { level: 'a', introduces: ['novae'] }, 'b'));
    await addLevels(editor, '', [{ stem: 'new', file: fileOf('new') }]);
    expect(entries()).toEqual(['c', { level: 'a', introduces: ['novae'] }, 'b', 'new']);
    await duplicateLevel(editor, entry('c'));
    expect(entries()).toEqual(['c', 'c-copy', { level: 'a', introduces: ['novae'] }, 'b', 'new']);
    const before = await textOnDisk();
    await deleteLevel(editor, entry('a'));
    expect(entries()).toEqual(['c', 'c-copy', 'b', 'new']);
    await undo();
    expect(await textOnDisk()).toBe(before);
    await redo();
    expect(entries()).toEqual(['c', 'c-copy', 'b', 'new']);
    // from the dialog of deleted levels it comes back as the last one
    const trash = await disk.trash();
    await restoreLevel(editor, trash.ok ? trash.value[0].trash : '', false);
    expect(entries()).toEqual(['c', 'c-copy', 'b', 'new', 'a']);
    expect(warnings()).toEqual([]);
  });

  it('change together also where another program has changed the order meanwhile: nothing of it is lost', async () => {
    await write(packOf('a', 'b', 'c'));
    await writeByOthers(packOf('c', { chapter: 'Theirs' }, 'b', 'a'));
    await deleteLevel(editor, entry('b'));
    expect(entries()).toEqual(['c', { chapter: 'Theirs' }, 'a']);
    await writeByOthers(packOf('c', 'a', { chapter: 'Theirs' }));
    await undo();
    expect(entries()).toEqual(['c', 'b', 'a', { chapter: 'Theirs' }]);
    expect(warnings()).toEqual([]);
  });

  it('a copy of a level that is not listed is not listed', async () => {
    await write(packOf('a'));
    await duplicateLevel(editor, entry('b'));
    expect(entries()).toEqual(['a']);
  });

  it('without pack.json there is none afterwards', async () => {
    await addLevels(editor, '', [{ stem: 'new', file: fileOf('new') }]);
    await deleteLevel(editor, entry('a'));
    expect(await textOnDisk()).toBe(null);
  });
});

describe('a change of the order', () => {
  it('makes pack.json where there is none, and undo removes it', async () => {
    const moved = (pack: PackFile) => moveEntries(pack, ids(), [2], 0);
    expect(await editPack(editor, 'Move c', moved)).toBe(true);
    expect(entries()).toEqual(['c', 'a', 'b']);
    await undo();
    expect([await textOnDisk(), ids()]).toEqual([null, ['a', 'b', 'c']]);
    await redo();
    expect(ids()).toEqual(['c', 'a', 'b']);
  });

  it('is refused where the file has changed on the disk, which is then shown', async () => {
    await write(packOf('a', 'b', 'c'));
    await writeByOthers(packOf('c', 'b', 'a'));
    expect(await editPack(editor, 'Move', (pack) => moveEntries(pack, ids(), [0], 3))).toBe(false);
    expect([await textOnDisk(), ids()]).toEqual([formatPack(packOf('c', 'b', 'a')), ['c', 'b', 'a']]);
    expect(warnings().map(({ text }) => text)).toEqual([expect.stringContaining('Another program has changed pack.json')]);
    expect(await editPack(editor, 'Move', (pack) => moveEntries(pack, ids(), [0], 3))).toBe(true);
    expect(ids()).toEqual(['b', 'a', 'c']);
    // the same for undo: their order stays
    await writeByOthers(packOf('a', 'c', 'b'));
    await undo();
    expect(ids()).toEqual(['a', 'c', 'b']);
  });

  it('is refused where the file is not valid', async () => {
    workspace.store.setState(({ list }) => ({
      list: list && { ...list, pack: { file: 'pack.json', etag: `"${'0'.repeat(64)}"`, text: '{', readOnly: null } },
    }));
    expect(await editPack(editor, 'Move', (pack) => pack)).toBe(false);
    expect(warnings()[0].text).toContain('not valid');
  });

  it('undone is the text as it was to the last byte, whatever was done: undo is identity', async () => {
    const act = fc.oneof(
      fc.tuple(fc.constant('move' as const), fc.nat(6), fc.nat(6)),
      fc.tuple(fc.constant('list' as const), fc.nat(3), fc.nat(3)),
      fc.tuple(fc.constant('chapter' as const), fc.nat(4), fc.constant(0)),
      fc.tuple(fc.constant('delete' as const), fc.nat(3), fc.constant(0)),
    );
    const some = fc.subarray(['a', 'b', 'c', 'd'], { minLength: 1 });
    await fc.assert(
      fc.asyncProperty(some, fc.array(act, { maxLength: 5 }), fc.boolean(), async (listed, acts, isNew) => {
        await start(['a', 'b', 'c', 'd']);
        // a layout of its own is kept, too
        const text = ` ${JSON.stringify(packOf(...listed))}`;
        if (!isNew) await workspace.writePack(text);
        // the storage of a browser puts a restored level last, and only a pack knows its place
        const now = async () => ({ text: await textOnDisk(), ids: [...ids()].sort() });
        const before = await now();
        for (const [kind, a, b] of acts) {
          if (kind === 'move') await editPack(editor, 'Move', (pack) => moveEntries(pack, ids(), [a], b));
          else if (kind === 'chapter') await editPack(editor, 'Chapter', (pack) => addChapter(pack, a, 'New'));
          else if (kind === 'list') moveTo(editor, levels(), levels()[a] ?? null, b);
          else if (levels()[a] !== undefined) await deleteLevel(editor, levels()[a]);
          await breathe();
        }
        const after = await now();
        let count = 0;
        while (listHistoryOf(editor).store.getState().undoLabel !== null && count++ < 20) await undo();
        expect(await now()).toEqual(before);
        for (let i = 0; i < count; i++) await redo();
        expect(await now()).toEqual(after);
        expect(warnings()).toEqual([]);
      }),
      { numRuns: 60 },
    );
  });
});
