import { createStore, type StoreApi } from 'zustand/vanilla';
import type { DeleteResponse, EditEvent, LevelEntry, ListResponse, OrderResponse } from '../../schema/index.ts';
import type { EditedLevel } from '../document/index.ts';
import type { Answer, LevelStorage, Link, StorageError } from './level-storage.ts';
import { type OpenedLevel, type Opening, openLevel, type Surroundings } from './open-level.ts';

/** The folder that is edited. */
export interface WorkspaceState {
  /** null until the storage has answered once */
  readonly list: ListResponse | null;
  readonly link: Link;
  /** Why there is no list. */
  readonly error: StorageError | null;
  /** The level that is open; null: none, or one that is no valid level. */
  readonly opened: OpenedLevel | null;
  /** What was opened last and is not a level that can be edited. */
  readonly refused: { readonly id: string; readonly opening: Exclude<Opening, { ok: true }> } | null;
}

export interface Workspace {
  readonly store: StoreApi<WorkspaceState>;
  readonly storage: LevelStorage;
  /** Asks for the list, and follows what happens to the folder. @returns when the list is there, or an error */
  start(): Promise<void>;
  /** Opens a level in place of the one that is open, whose changes are written first. */
  open(id: string): Promise<Opening>;
  /** Asks for the list again. */
  refresh(): Promise<void>;
  /** Renames a level; the open one stays open. What is unsaved in it is written first, here and in what follows. */
  rename(entry: LevelEntry, to: string): Promise<Answer<LevelEntry>>;
  duplicate(entry: LevelEntry, to: string): Promise<Answer<LevelEntry>>;
  /** Moves a level to the trash. The open one stays on the screen until another is opened or it is left. */
  remove(entry: LevelEntry): Promise<Answer<DeleteResponse>>;
  /** @param to its new id; its old one when left out */
  restore(trash: string, to?: string): Promise<Answer<LevelEntry>>;
  /** Puts the levels of a folder into another order, on the screen at once; their files are renumbered. */
  order(folder: string, ids: readonly string[]): Promise<Answer<OrderResponse>>;
  /** Closes the level that is open. */
  leave(): Promise<void>;
  close(): Promise<void>;
}

/** The levels of a storage, one of them open. Histories of levels that were open are remembered as long as the page lives. */
export function createWorkspace(surroundings: Omit<Surroundings, 'folder'>): Workspace {
  const { storage } = surroundings;
  const store = createStore<WorkspaceState>(() => ({ list: null, link: 'up', error: null, opened: null, refused: null }));
  const remembered = new Map<string, EditedLevel>();
  let stop = () => {};
  /** Opening and closing follow one another. */
  let last: Promise<unknown> = Promise.resolve();

  const setLevels = (change: (levels: readonly LevelEntry[]) => LevelEntry[]) => {
    const { list } = store.getState();
    if (list !== null) store.setState({ list: { ...list, levels: change(list.levels) } });
  };
  /** With an entry in its place; where that is, the storage says for certain. */
  const withEntry = (levels: readonly LevelEntry[], entry: LevelEntry, from: string): LevelEntry[] => {
    const index = levels.findIndex(({ id }) => id === from);
    return index < 0 ? [...levels, entry] : levels.map((other, i) => (i === index ? entry : other));
  };
  /** Histories and the open level go by their new ids; all at once, since ids may change places. */
  const follow = (renamed: readonly { readonly from: string; readonly entry: LevelEntry }[]) => {
    const histories = renamed.map(({ from }) => remembered.get(from));
    for (const { from } of renamed) remembered.delete(from);
    for (const [i, { entry }] of renamed.entries()) {
      const edited = histories[i];
      if (edited !== undefined) remembered.set(entry.id, edited);
    }
    const { opened } = store.getState();
    const now = renamed.find(({ from }) => from === opened?.id())?.entry;
    if (now?.etag != null) opened?.moved(now.id, now.etag);
  };
  /** Ids that were reported since a list began: a long one comes in parts, and until the last one what was known stays on the screen. */
  let heard = new Set<string>();
  const hear = (levels: readonly LevelEntry[], next: ListResponse) => {
    const { list, opened } = store.getState();
    const reported = new Map(levels.map((entry) => [entry.id, entry]));
    for (const id of reported.keys()) heard.add(id);
    const isWhole = next.unread === 0;
    if (isWhole && reported.size === heard.size) store.setState({ list: { ...next, levels: [...levels] }, error: null });
    else {
      const before = list?.levels ?? [];
      const kept = before.filter(({ id }) => !isWhole || heard.has(id)).map((entry) => reported.get(entry.id) ?? entry);
      const known = new Set(before.map(({ id }) => id));
      store.setState({ list: { ...next, levels: [...kept, ...levels.filter(({ id }) => !known.has(id))] }, error: null });
    }
    // one that was not reported is looked for once all are
    if (opened === null) return;
    if (reported.has(opened.id())) opened.saver.refresh(reported.get(opened.id())?.etag);
    else if (isWhole && !heard.has(opened.id())) opened.saver.refresh();
  };
  const refreshList = async () => {
    const answer = await storage.list();
    store.setState(answer.ok ? { list: answer.value, error: null } : { error: answer.error });
  };
  const onEvent = (event: EditEvent) => {
    const { opened } = store.getState();
    switch (event.type) {
      case 'list':
        heard = new Set();
        hear(event.list.levels, event.list);
        break;
      case 'read': {
        const { list } = store.getState();
        if (list !== null) hear(event.levels, { ...list, unread: event.unread });
        break;
      }
      case 'changed': {
        const isNew = store.getState().list?.levels.every(({ id }) => id !== event.entry.id);
        setLevels((levels) => withEntry(levels, event.entry, event.entry.id));
        if (isNew) void refreshList();
        if (opened?.id() === event.entry.id) opened.saver.refresh(event.entry.etag);
        break;
      }
      case 'removed':
        setLevels((levels) => levels.filter(({ id }) => id !== event.id));
        if (opened?.id() === event.id) opened.saver.refresh();
        break;
      case 'renamed':
        follow([event]);
        setLevels((levels) => withEntry(levels, event.entry, event.from));
        void refreshList();
        break;
    }
  };
  /** The etag that a level has once what is unsaved is on the disk. */
  const baseOf = async ({ id, etag }: LevelEntry): Promise<string> => {
    const { opened } = store.getState();
    if (opened?.id() !== id) return etag ?? '';
    await opened.saver.flush();
    return opened.saver.base().etag ?? '';
  };
  /** Storages don't tell a page what it did itself; and what was refused may rest on an old list. */
  const listed = async <T>(answer: Answer<T>): Promise<Answer<T>> => {
    if (answer.ok || ['conflict', 'unknown-level', 'list-changed'].includes(answer.error.code)) await refreshList();
    return answer;
  };
  /** Writes what is unsaved; its history waits for the next time. */
  const putAway = async (opened: OpenedLevel) => {
    await opened.close();
    remembered.set(opened.id(), opened.level);
  };
  const closeOpened = async () => {
    const { opened } = store.getState();
    if (opened === null) return;
    store.setState({ opened: null });
    await putAway(opened);
  };
  const inTurn = <T>(act: () => Promise<T>): Promise<T> => {
    const turn = last.then(act, act);
    last = turn;
    return turn;
  };

  return {
    store,
    storage,
    async start() {
      await refreshList();
      stop = storage.watch(onEvent, (link) => {
        store.setState({ link });
        if (link === 'up') store.getState().opened?.saver.retry();
      });
    },
    open: (id) =>
      inTurn(async () => {
        const { opened: old, list } = store.getState();
        // a level can't be written by two at once; any other one stays on the screen until the next is there
        if (old?.id() === id) await closeOpened();
        const opening = await openLevel(id, { ...surroundings, folder: list?.folder.id ?? '' }, remembered.get(id));
        const leaving = store.getState().opened;
        if (opening.ok) store.setState({ opened: opening.opened, refused: null });
        else store.setState({ opened: null, refused: { id, opening } });
        if (leaving !== null) await putAway(leaving);
        return opening;
      }),
    refresh: refreshList,
    async rename(entry, to) {
      const answer = await storage.rename(entry.id, to, await baseOf(entry));
      if (answer.ok) follow([{ from: entry.id, entry: answer.value }]);
      return listed(answer);
    },
    duplicate: async (entry, to) => listed(await storage.duplicate(entry.id, to, await baseOf(entry))),
    remove: async (entry) => listed(await storage.remove(entry.id, await baseOf(entry))),
    restore: async (trash, to) => listed(await storage.restore(trash, to)),
    async order(folder, ids) {
      await store.getState().opened?.saver.flush();
      setLevels((levels) => {
        const inOrder = ids.flatMap((id) => levels.find((entry) => entry.id === id) ?? []);
        return levels.map((entry) => (ids.includes(entry.id) ? (inOrder.shift() ?? entry) : entry));
      });
      const answer = await storage.order(folder, ids);
      if (answer.ok) {
        const { renamed, levels } = answer.value;
        follow(renamed.flatMap(({ from, to }) => levels.filter(({ id }) => id === to).map((entry) => ({ from, entry }))));
      }
      await refreshList();
      return answer;
    },
    leave: () => inTurn(closeOpened),
    close: () =>
      inTurn(async () => {
        stop();
        await closeOpened();
      }),
  };
}
