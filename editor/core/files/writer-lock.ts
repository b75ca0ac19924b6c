import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Timers } from './timers.ts';

/** `writer`: this page may write the level. `reader`: another page has it. `waiting`: not known yet. */
export type Role = 'writer' | 'reader' | 'waiting';

/** The part of a BroadcastChannel that is needed. */
export interface Channel {
  postMessage(message: unknown): void;
  addEventListener(type: 'message', listener: (event: { readonly data: unknown }) => void): void;
  close(): void;
}

/** What the writer shows the readers. */
export interface Shown {
  readonly text: string;
  /** The state on disk as the writer knows it: a page that takes over continues from there. */
  readonly base: { readonly text: string; readonly etag: string | null };
}

/** One page writes a level; the others show what it does. */
export interface WriterLock {
  readonly store: StoreApi<Role>;
  /** Makes this page the writer. The current writer first saves its changes, if it responds. */
  takeOver(): void;
  /** Tells readers the current state of the level; only the writer does. */
  tell(shown: Shown): void;
  /** The level was renamed: its writer stays the writer. */
  moveTo(name: string, channel: Channel | null): void;
  close(): void;
}

export interface WriterLockOptions {
  /**
   * The page's `navigator.locks`; null if there are none: then every page is a writer, and the storage refuses conflicting
   * writes.
   */
  readonly locks: Pick<LockManager, 'request'> | null;
  /** A channel between the pages that have this level open. */
  readonly channel: Channel | null;
  readonly timers: Timers;
  /** A name for the level that all pages share. */
  readonly name: string;
  /** Called before the level is handed to another page: saves the changes. */
  readonly beforeHandOver: () => Promise<unknown>;
  /** Called in readers with the state of the writer. */
  readonly onShown: (shown: Shown) => void;
  /** The state of this page, for a reader that has just arrived. */
  readonly shown: () => Shown;
}

/** ms that a writer may take to save its changes before another page takes over */
const PATIENCE = 1500;

type Message = { readonly type: 'shown'; readonly shown: Shown } | { readonly type: 'hello' | 'hand-over' };

const isMessage = (data: unknown): data is Message =>
  typeof data === 'object' && data !== null && typeof (data as { type?: unknown }).type === 'string';

/** Asks to be the writer of a level. The page becomes the writer if there is none, or when the current one is gone. */
export function claimLevel(options: WriterLockOptions): WriterLock {
  const { locks, timers, beforeHandOver, onShown, shown } = options;
  let { name, channel } = options;
  const store = createStore<Role>(() => (locks === null ? 'writer' : 'waiting'));
  let letGo: (() => void) | null = null;
  /** Releases the lock of the previous name. */
  let letGoOfOld = () => {};
  let waiting: AbortController | null = null;
  let cancelPatience = () => {};
  let isClosed = false;

  const become = (role: Role) => {
    if (!isClosed && store.getState() !== role) store.setState(role, true);
  };
  /** Holds the lock until it is released; resolves at once if this page was closed in the meantime. */
  const hold = (lock: Lock | null): Promise<void> | undefined => {
    if (isClosed) return undefined;
    if (lock === null) {
      become('reader');
      channel?.postMessage({ type: 'hello' } satisfies Message);
      queue();
      return undefined;
    }
    cancelPatience();
    waiting?.abort();
    waiting = null;
    become('writer');
    return new Promise((resolve) => {
      letGo = resolve;
    });
  };
  const request = (how: LockOptions) => {
    const asked = name;
    void locks?.request(asked, how, hold).catch(() => {
      // stolen by another page, or no longer wanted
      if (letGo === null || asked !== name || how.signal?.aborted === true) return;
      letGo = null;
      lose();
    });
  };
  const lose = () => {
    become('reader');
    channel?.postMessage({ type: 'hello' } satisfies Message);
    queue();
  };
  /** Waits until the writer is gone. */
  const queue = () => {
    if (waiting !== null || isClosed) return;
    waiting = new AbortController();
    request({ signal: waiting.signal });
  };
  const handOver = async () => {
    await beforeHandOver();
    const release = letGo;
    letGo = null;
    release?.();
    // queue again, behind the page that asked for it
    lose();
  };

  const listen = (to: Channel | null) =>
    to?.addEventListener('message', ({ data }) => {
      if (isClosed || to !== channel || !isMessage(data)) return;
      const isWriter = store.getState() === 'writer';
      if (data.type === 'shown' && !isWriter) onShown(data.shown);
      else if (data.type === 'hello' && isWriter) to.postMessage({ type: 'shown', shown: shown() } satisfies Message);
      else if (data.type === 'hand-over' && isWriter && letGo !== null) void handOver();
    });
  listen(channel);
  request({ ifAvailable: true });

  return {
    store,
    takeOver() {
      if (locks === null || store.getState() === 'writer') return;
      channel?.postMessage({ type: 'hand-over' } satisfies Message);
      cancelPatience();
      // a frozen or crashed page does not respond
      cancelPatience = timers.after(PATIENCE, () => request({ steal: true }));
    },
    tell(now) {
      if (store.getState() === 'writer') channel?.postMessage({ type: 'shown', shown: now } satisfies Message);
    },
    moveTo(to, by) {
      channel?.close();
      name = to;
      channel = by;
      listen(channel);
      if (locks === null) return;
      cancelPatience();
      waiting?.abort();
      waiting = null;
      if (store.getState() === 'writer') {
        const release = letGo ?? (() => {});
        letGoOfOld();
        letGoOfOld = release;
        // A page that already holds the new name has written nothing under it, so the lock is stolen. Pages that wait for the
        // old name must learn the new one before the old lock is released.
        request({ steal: true });
        timers.after(2 * PATIENCE, release);
        return;
      }
      // the writer must get the new lock first
      cancelPatience = timers.after(PATIENCE, () => {
        channel?.postMessage({ type: 'hello' } satisfies Message);
        queue();
      });
    },
    close() {
      isClosed = true;
      cancelPatience();
      waiting?.abort();
      letGo?.();
      letGo = null;
      letGoOfOld();
      channel?.close();
    },
  };
}
