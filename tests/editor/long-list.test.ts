import { expect, it } from 'vitest';
import { NO_FOLDER_TERMS } from '../../editor/core/files/folder-list.ts';
import { createWorkspace, type LevelStorage, pageTimers } from '../../editor/core/files/index.ts';
import type { Journal } from '../../editor/core/journal/index.ts';
import type { EditEvent, LevelEntry, ListResponse } from '../../schema/index.ts';
import { passingVersions } from './stage.ts';

const entry = (id: string, name: string = id): LevelEntry => ({
  id,
  file: `${id}.level.json`,
  etag: `"${'0'.repeat(64)}"`,
  status: 'valid',
  name,
  problems: [],
  readOnly: null,
});

const listOf = (ids: readonly string[], unread: number): ListResponse => ({
  folder: { id: 'f', path: 'levels', $schema: null },
  folders: [''],
  levels: ids.map((id) => entry(id)),
  terms: NO_FOLDER_TERMS,
  troubles: [],
  unread,
});

/** A page with a storage that has only a list and events. */
async function pageOn(first: ListResponse) {
  let tell: (event: EditEvent) => void = () => {};
  const storage = {
    kind: 'server',
    list: async () => ({ ok: true, value: first }),
    watch(onEvent: (event: EditEvent) => void) {
      tell = onEvent;
      return () => {};
    },
  } as unknown as LevelStorage;
  const workspace = createWorkspace({
    storage,
    journal: {} as Journal,
    versions: passingVersions(),
    timers: pageTimers,
    locks: null,
    channel: () => null,
  });
  await workspace.start();
  const ids = () => workspace.store.getState().list?.levels.map(({ id }) => id);
  const unread = () => workspace.store.getState().list?.unread;
  return { tell: (event: EditEvent) => tell(event), ids, unread, workspace };
}

it('a list that arrives in parts grows, with each level once', async () => {
  const page = await pageOn(listOf(['a', 'b'], 3));
  page.tell({ type: 'list', list: listOf(['a', 'b'], 3) });
  page.tell({ type: 'read', levels: [entry('c'), entry('d')], unread: 1 });
  expect([page.ids(), page.unread()]).toEqual([['a', 'b', 'c', 'd'], 1]);
  page.tell({ type: 'read', levels: [entry('e')], unread: 0 });
  expect([page.ids(), page.unread()]).toEqual([['a', 'b', 'c', 'd', 'e'], 0]);
});

it('a new list in parts removes levels from the screen only once it is complete', async () => {
  const page = await pageOn(listOf(['a', 'b', 'c', 'd'], 0));
  page.tell({ type: 'list', list: { ...listOf(['a'], 2), levels: [entry('a', 'new name')] } });
  expect([page.ids(), page.unread()]).toEqual([['a', 'b', 'c', 'd'], 2]);
  expect(page.workspace.store.getState().list?.levels[0].name).toBe('new name');
  page.tell({ type: 'read', levels: [entry('c'), entry('x')], unread: 0 });
  expect([page.ids(), page.unread()]).toEqual([['a', 'c', 'x'], 0]);
  page.tell({ type: 'list', list: listOf(['x'], 0) });
  expect(page.ids()).toEqual(['x']);
});
