import { createStore, type StoreApi } from 'zustand/vanilla';
import {
  type DeleteResponse,
  type EditEvent,
  type LevelEntry,
  type ListResponse,
  levelsOfPack,
  type OrderResponse,
  type PackOnDisk,
} from '../../../schema/index.ts';
import { createListeners } from '../document/index.ts';
import type { Move } from '../versions/index.ts';
import { folderPackIn, idsIn, inOrder, inOrderOfPack, withEntry, withKeptPack, withKeptTerms, withPart } from './folder-list.ts';
import type { Answer, LevelStorage, Link, StorageError } from './level-storage.ts';
import { type OpenedLevel, type Opening, openLevel, placeOf, type Remembered, type Surroundings } from './open-level.ts';

/** The folder that is edited. */
interface WorkspaceState {
  /** null until the storage has answered once */
  readonly list: ListResponse | null;
  readonly link: Link;
  /** Why there is no list. */
  readonly error: StorageError | null;
  /** The open level; null if none is open or the file is not a valid level. */
  readonly opened: OpenedLevel | null;
  /** The last opened file, if it was not a level that can be edited. */
  readonly refused: { readonly id: string; readonly opening: Exclude<Opening, { ok: true }> } | null;
}

export interface Workspace {
  readonly store: StoreApi<WorkspaceState>;
  readonly storage: LevelStorage;
  /** Requests the list and follows changes of the folder. @returns resolves when the list or an error is there */
  start(): Promise<void>;
  /** Opens a level in place of the open one, whose changes are saved first. */
  open(id: string): Promise<Opening>;
  /** The number of times a level was requested. A slow action compares it to see whether the user has moved on. */
  openings(): number;
  /** Requests the list again. */
  refresh(): Promise<void>;
  /** Renames a level; the open level stays open. As in the next functions, its unsaved changes are written first. */
  rename(entry: LevelEntry, to: string): Promise<Answer<LevelEntry>>;
  duplicate(entry: LevelEntry, to: string): Promise<Answer<LevelEntry>>;
  /** Moves a level to the trash. If it is open, it stays on the screen until another is opened or it is left. */
  remove(entry: LevelEntry): Promise<Answer<DeleteResponse>>;
  /** @param to its new id; by default its old one */
  restore(trash: string, to?: string): Promise<Answer<LevelEntry>>;
  /**
   * Reorders the levels of a folder, on the screen at once; their files are renumbered. Levels unknown to the page keep their
   * places, and deleted ones are left out.
   */
  order(folder: string, ids: readonly string[]): Promise<Answer<OrderResponse>>;
  /**
   * Writes the `pack.json` of the folder, or removes it (null); the list follows at once. It is refused if the file is not the one
   * that the page knows; then the list has the other one.
   */
  writePack(text: string | null): Promise<Answer<PackOnDisk | null>>;
  /** Calls back when levels got other places: they were renamed, deleted, restored or reordered. @returns stops it */
  onMoved(listener: (moves: readonly Move[]) => void): () => void;
  /** Closes the open level. */
  leave(): Promise<void>;
  close(): Promise<void>;
}

/** The levels of a storage, one of them open. The histories of levels are kept as long as the page lives. */
export const createWorkspace = (surroundings: Omit<Surroundings, 'folder'>): Workspace => new StorageWorkspace(surroundings);

/** Where the versions of a level are kept while it is in the trash; no id has such a name. */
const inTrash = (trash: string): string => `?trash/${trash}`;

/** A level with a new id. */
interface Renamed {
  readonly from: string;
  readonly entry: LevelEntry;
}

class StorageWorkspace implements Workspace {
  readonly store: StoreApi<WorkspaceState>;
  readonly storage: LevelStorage;
  private readonly remembered = new Map<string, Remembered>();
  /** The earlier ids of renamed levels, by which `pack.json` may still list them. */
  private readonly former = new Map<string, string>();
  private readonly moved = createListeners<readonly Move[]>();
  /** Ids received since a list began: a long list comes in parts. */
  private heard = new Set<string>();
  /** Opening and closing happen one after the other. */
  private last: Promise<unknown> = Promise.resolve();
  private asked = 0;
  private stop = () => {};

  constructor(private readonly surroundings: Omit<Surroundings, 'folder'>) {
    this.storage = surroundings.storage;
    this.store = createStore<WorkspaceState>(() => ({ list: null, link: 'up', error: null, opened: null, refused: null }));
  }

  async start(): Promise<void> {
    await this.refresh();
    this.stop = this.storage.watch(
      (event) => this.hear(event),
      (link) => {
        this.store.setState({ link });
        if (link === 'up') this.store.getState().opened?.saver.retry();
      },
    );
  }

  openings(): number {
    return this.asked;
  }

  open(id: string): Promise<Opening> {
    this.asked++;
    return this.inTurn(async () => {
      const { opened: old, list } = this.store.getState();
      // One level can't be open twice at a time; another level stays on the screen until the next one is ready.
      if (old?.id() === id) await this.closeOpened();
      const surroundings = { ...this.surroundings, folder: list?.folder.id ?? '' };
      const opening = await openLevel(id, surroundings, this.remembered.get(id));
      const leaving = this.store.getState().opened;
      if (opening.ok) this.store.setState({ opened: opening.opened, refused: null });
      else this.store.setState({ opened: null, refused: { id, opening } });
      if (leaving !== null) await this.putAway(leaving);
      return opening;
    });
  }

  async refresh(): Promise<void> {
    const answer = await this.storage.list();
    if (answer.ok) this.setList(answer.value, { error: null });
    else this.store.setState({ error: answer.error });
  }

  async rename(entry: LevelEntry, to: string): Promise<Answer<LevelEntry>> {
    const answer = await this.storage.rename(entry.id, to, await this.baseOf(entry));
    if (answer.ok) this.follow([{ from: entry.id, entry: answer.value }]);
    return this.listed(answer);
  }

  async duplicate(entry: LevelEntry, to: string): Promise<Answer<LevelEntry>> {
    const answer = await this.storage.duplicate(entry.id, to, await this.baseOf(entry));
    // a copy begins anew, whatever had its name before
    if (answer.ok) this.moveVersions([{ from: to, to: `${to}?before`, of: answer.value.etag }]);
    return this.listed(answer);
  }

  async remove(entry: LevelEntry): Promise<Answer<DeleteResponse>> {
    const answer = await this.storage.remove(entry.id, await this.baseOf(entry));
    if (answer.ok) {
      const { trash, id } = answer.value.trashed;
      this.moveVersions([{ from: id, to: inTrash(trash), of: trash }]);
    }
    return this.listed(answer);
  }

  async restore(trash: string, to?: string): Promise<Answer<LevelEntry>> {
    const answer = await this.storage.restore(trash, to);
    if (answer.ok) this.moveVersions([{ from: inTrash(trash), to: answer.value.id, of: trash }]);
    return this.listed(answer);
  }

  async order(folder: string, ids: readonly string[]): Promise<Answer<OrderResponse>> {
    await this.store.getState().opened?.saver.flush();
    this.setLevels((levels) => inOrder(levels, ids));
    let answer = await this.storage.order(folder, ids);
    if (!answer.ok && answer.error.code === 'list-changed') {
      // the page's list was outdated
      await this.refresh();
      this.setLevels((levels) => inOrder(levels, ids));
      answer = await this.storage.order(folder, idsIn(this.store.getState().list?.levels ?? [], folder));
    }
    if (answer.ok) {
      const { renamed, levels } = answer.value;
      this.follow(renamed.flatMap(({ from, to }) => levels.filter(({ id }) => id === to).map((entry) => ({ from, entry }))));
    }
    await this.refresh();
    return answer;
  }

  async writePack(text: string | null): Promise<Answer<PackOnDisk | null>> {
    const base = this.store.getState().list?.pack?.etag ?? null;
    const answer = await this.storage.writePack(text, base);
    if (answer.ok) this.setPack(answer.value);
    // levels that it does not list have places of their own, which the storage knows
    if (answer.ok ? !this.isWholeListed() : answer.error.code === 'conflict') await this.refresh();
    return answer;
  }

  onMoved(listener: (moves: readonly Move[]) => void): () => void {
    return this.moved.add(listener);
  }

  leave(): Promise<void> {
    return this.inTurn(() => this.closeOpened());
  }

  close(): Promise<void> {
    return this.inTurn(async () => {
      this.stop();
      await this.closeOpened();
    });
  }

  /** Handles an event of the folder. */
  private hear(event: EditEvent): void {
    const { list, opened } = this.store.getState();
    switch (event.type) {
      case 'list':
        this.heard = new Set();
        this.hearPart(event.list.levels, event.list);
        break;
      case 'read':
        if (list !== null) this.hearPart(event.levels, { ...list, unread: event.unread });
        break;
      case 'changed': {
        const isNew = list?.levels.every(({ id }) => id !== event.entry.id);
        this.setLevels((levels) => withEntry(levels, event.entry, event.entry.id));
        if (isNew) void this.refresh();
        if (opened?.id() === event.entry.id) opened.saver.refresh(event.entry.etag);
        break;
      }
      case 'removed':
        this.setLevels((levels) => levels.filter(({ id }) => id !== event.id));
        if (opened?.id() === event.id) opened.saver.refresh();
        break;
      case 'terms':
        if (list !== null) this.setList({ ...list, terms: event.terms });
        break;
      case 'pack':
        this.setPack(event.pack);
        // levels that it no longer lists have places of their own
        void this.refresh();
        break;
      case 'renamed':
        this.follow([event]);
        this.setLevels((levels) => withEntry(levels, event.entry, event.from));
        void this.refresh();
        break;
    }
  }

  /** Handles a part of a list, or all of it. @param next the list that contains it */
  private hearPart(levels: readonly LevelEntry[], next: ListResponse): void {
    const { heard, store } = this;
    const { list, opened } = store.getState();
    for (const { id } of levels) heard.add(id);
    const isWhole = next.unread === 0;
    this.setList({ ...next, levels: withPart(list?.levels ?? [], levels, heard, isWhole) }, { error: null });
    if (opened === null) return;
    const entry = levels.findLast(({ id }) => id === opened.id());
    if (entry !== undefined) opened.saver.refresh(entry.etag);
    // a level that was not in any part is looked up once all parts are there
    else if (isWhole && !heard.has(opened.id())) opened.saver.refresh();
  }

  private setList(list: ListResponse, more: Partial<WorkspaceState> = {}): void {
    const before = this.store.getState().list;
    this.store.setState({ list: inOrderOfPack(withKeptPack(withKeptTerms(list, before), before), this.former), ...more });
  }

  private isWholeListed(): boolean {
    const { list } = this.store.getState();
    const pack = folderPackIn({ list });
    const listed = new Set(pack.kind === 'valid' ? levelsOfPack(pack.reading.pack) : []);
    return list?.levels.every(({ id }) => listed.has(id)) === true;
  }

  private setPack(pack: PackOnDisk | null): void {
    const { list } = this.store.getState();
    if (list === null) return;
    const { pack: _, ...rest } = list;
    this.setList(pack === null ? rest : { ...rest, pack });
  }

  private setLevels(change: (levels: readonly LevelEntry[]) => LevelEntry[]): void {
    const { list } = this.store.getState();
    if (list !== null) this.store.setState({ list: inOrderOfPack({ ...list, levels: change(list.levels) }, this.former) });
  }

  /** Moves what this browser keeps of the versions of levels. @param of tells this move from others between the same places */
  private moveVersions(moves: readonly { readonly from: string; readonly to: string; readonly of: string | null }[]): void {
    const folder = this.store.getState().list?.folder.id ?? '';
    const places = moves.map(({ from, to, of }) => ({
      from: placeOf(folder, from),
      to: placeOf(folder, to),
      token: `${from} to ${to} ${of}`,
    }));
    this.surroundings.versions.moved(places);
    this.moved.call(places);
  }

  /** Moves histories and the open level to their new ids; all at once, as levels may swap ids. */
  private follow(renamed: readonly Renamed[]): void {
    this.moveVersions(renamed.map(({ from, entry }) => ({ from, to: entry.id, of: entry.etag })));
    const { remembered, former } = this;
    const before = renamed.map(({ from }) => former.get(from) ?? from);
    for (const { from } of renamed) former.delete(from);
    for (const [i, { entry }] of renamed.entries()) former.set(entry.id, before[i]);
    const histories = renamed.map(({ from }) => remembered.get(from));
    for (const { from } of renamed) remembered.delete(from);
    for (const [i, { entry }] of renamed.entries()) {
      const edited = histories[i];
      if (edited !== undefined) remembered.set(entry.id, edited);
    }
    const { opened } = this.store.getState();
    const now = renamed.find(({ from }) => from === opened?.id())?.entry;
    if (now?.etag != null) opened?.moved(now.id, now.etag);
  }

  /** The etag of a level once its unsaved changes are on disk. */
  private async baseOf({ id, etag }: LevelEntry): Promise<string> {
    const { opened } = this.store.getState();
    if (opened?.id() !== id) return etag ?? '';
    await opened.saver.flush();
    return opened.saver.base().etag ?? '';
  }

  /** Refreshes the list: storages do not report a page's own changes, and a refusal may be due to an outdated list. */
  private async listed<T>(answer: Answer<T>): Promise<Answer<T>> {
    if (answer.ok || ['conflict', 'unknown-level', 'list-changed'].includes(answer.error.code)) await this.refresh();
    return answer;
  }

  /** Saves the changes of a level and keeps its history for the next time. */
  private async putAway(opened: OpenedLevel): Promise<void> {
    await opened.close();
    this.remembered.set(opened.id(), opened.remember());
  }

  private async closeOpened(): Promise<void> {
    const { opened } = this.store.getState();
    if (opened === null) return;
    this.store.setState({ opened: null });
    await this.putAway(opened);
  }

  private inTurn<T>(act: () => Promise<T>): Promise<T> {
    const turn = this.last.then(act, act);
    this.last = turn;
    return turn;
  }
}

/** The list of levels once it is complete: a long one comes in parts. */
export function allLevels({ store }: Pick<Workspace, 'store'>): Promise<readonly LevelEntry[]> {
  return new Promise((resolve) => {
    let stop = () => {};
    const look = () => {
      const { list, error } = store.getState();
      if (error === null && list !== null && list.unread > 0) return false;
      stop();
      resolve(list?.levels ?? []);
      return true;
    };
    if (!look()) stop = store.subscribe(look);
  });
}
