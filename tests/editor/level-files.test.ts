import { beforeEach, describe, expect, it } from 'vitest';
import { createStore } from 'zustand/vanilla';
import type { Editor, OpenLevel } from '../../editor/core/context/index.ts';
import { createBrowserStorage, createOpeningMarks, createWorkspace, type Workspace } from '../../editor/core/files/index.ts';
import { createJournal, createMemoryStore } from '../../editor/core/journal/index.ts';
import {
  addLevels,
  deleteLevel,
  duplicateLevel,
  openListed,
  orderLevels,
  restoreLevel,
} from '../../editor/core/levels/level-files.ts';
import { listHistoryOf } from '../../editor/core/levels/list-history.ts';
import { createNotices } from '../../editor/core/notices/index.ts';
import { formatLevel, type LevelEntry, type LevelFile } from '../../schema/index.ts';
import { breathe, createChannels, createKeyValues, createLine, LockKeeper, passingVersions, TurnedClock } from './stage.ts';

const fileOf = (name: string): LevelFile => ({ version: 1, name, astronaut: { x: 0, y: 0 }, blackHole: { x: 300, y: 0 } });

let editor: Editor;
let workspace: Workspace;
let line: ReturnType<typeof createLine>;

beforeEach(async () => {
  const disk = createBrowserStorage(createKeyValues(), null, () => 0);
  for (const id of ['a', 'b', 'c']) await disk.write(id, formatLevel(fileOf(id)), null);
  line = createLine(disk);
  const timers = new TurnedClock();
  workspace = createWorkspace({
    ...{ storage: line, journal: createJournal(createMemoryStore(), () => 0), versions: passingVersions(), timers },
    ...{ channel: createChannels(), locks: new LockKeeper().of('page') },
  });
  await workspace.start();
  const parts: Partial<Editor> = {
    ...{ workspace, notices: createNotices(), marks: createOpeningMarks(null, 'tab') },
    open: createStore<OpenLevel | null>(() => null),
  };
  editor = parts as Editor;
  await openListed(editor, 'a');
});

const entry = (id: string) => workspace.store.getState().list?.levels.find((level) => level.id === id) as LevelEntry;
const listed = () => workspace.store.getState().list?.levels.map(({ id }) => id);
const shown = () => workspace.store.getState().opened?.id();
const complaints = () => editor.notices.store.getState().filter(({ severity }) => severity !== 'info');

describe('the result of an action is opened', () => {
  const removed = async (id: string): Promise<string> => {
    await workspace.remove(entry(id));
    const trash = await workspace.storage.trash();
    return trash.ok ? trash.value[0].trash : '';
  };
  const cases: readonly [string, () => Promise<() => Promise<unknown>>, string][] = [
    ['a copy', async () => () => duplicateLevel(editor, entry('a')), 'a-copy'],
    ['a new level', async () => () => addLevels(editor, '', [{ stem: 'new', file: fileOf('new') }]), 'new'],
    ['the level after a deleted one', async () => () => deleteLevel(editor, entry('a')), 'b'],
    [
      'a level that was brought back',
      async () => {
        const trash = await removed('b');
        return () => restoreLevel(editor, trash, true);
      },
      'b',
    ],
  ];
  for (const [what, prepare, id] of cases) {
    it(what, async () => {
      const act = await prepare();
      await act();
      expect(shown()).toBe(id);
    });
    it(`${what}: not if another level was opened in the meantime`, async () => {
      const act = await prepare();
      const acting = act();
      await openListed(editor, 'c');
      await acting;
      expect(shown()).toBe('c');
      expect(complaints()).toEqual([]);
    });
  }
});

describe('another order', () => {
  it('is correct even if another program has added and removed levels unknown to the page', async () => {
    await line.write('d', formatLevel(fileOf('d')), null);
    await line.remove('c', entry('c').etag ?? '');
    await orderLevels(editor, '', ['c', 'b', 'a']);
    expect(complaints()).toEqual([]);
    expect(listed()).toEqual(['b', 'a', 'd']);
    listHistoryOf(editor).undo();
    await breathe();
    expect(listed()).toEqual(['a', 'b', 'd']);
    expect(complaints()).toEqual([]);
  });
});

describe('undo that is asked for while an action goes on', () => {
  it('waits for it and takes it back, not the step before', async () => {
    await orderLevels(editor, '', ['c', 'b', 'a']);
    const acting = deleteLevel(editor, entry('b'));
    expect(listHistoryOf(editor).store.getState()).toMatchObject({ undoLabel: 'Delete "b"', undoesList: true });
    listHistoryOf(editor).undo();
    await acting;
    await breathe();
    expect([...(listed() ?? [])].sort()).toEqual(['a', 'b', 'c']);
    expect(listHistoryOf(editor).store.getState()).toMatchObject({
      undoLabel: 'Reorder levels',
      redoLabel: 'Delete "b"',
    });
    expect(complaints()).toEqual([]);
  });

  it('of two actions takes back the later one first', async () => {
    const acting = Promise.all([deleteLevel(editor, entry('b')), deleteLevel(editor, entry('c'))]);
    listHistoryOf(editor).undo();
    await acting;
    await breathe();
    expect(listed()).toEqual(['a', 'c']);
    listHistoryOf(editor).undo();
    await breathe();
    expect([...(listed() ?? [])].sort()).toEqual(['a', 'b', 'c']);
  });

  it('takes nothing back if the action is refused', async () => {
    await orderLevels(editor, '', ['c', 'b', 'a']);
    const stale = entry('b');
    await line.write('b', formatLevel({ ...fileOf('b'), name: 'changed' }), stale.etag);
    const acting = deleteLevel(editor, stale);
    listHistoryOf(editor).undo();
    await acting;
    await breathe();
    expect(listed()).toEqual(['c', 'b', 'a']);
    expect(complaints()).toHaveLength(1);
    expect(listHistoryOf(editor).store.getState().undoLabel).toBe('Reorder levels');
  });
});
