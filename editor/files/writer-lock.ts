import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Timers } from './timers.ts';

/** `writer`: this page may write the level. `reader`: another page has it. `waiting`: not known yet. */
export type Role = 'writer' | 'reader' | 'waiting';

/** What of a BroadcastChannel is needed. */
export interface Channel {
  postMessage(message: unknown): void;
  addEventListener(type: 'message', listener: (event: { readonly data: unknown }) => void): void;
  close(): void;
}

/** What the page that writes shows the others. */
export interface Shown {
  readonly text: string;
  /** What it knows to be on the disk: a page that takes over goes on from there. */
  readonly base: { readonly text: string; readonly etag: string | null };
}

/** One page writes a level; the others see what it does. */
export interface WriterLock {
  readonly store: StoreApi<Role>;
  /** Makes this page the one that writes. The other one writes what it has first, if it answers. */
  takeOver(): void;
  /** The writer tells readers what the level is like now. */
  tell(shown: Shown): void;
  /** The level has another name from now on: who writes it goes on writing it. */
  moveTo(name: string, channel: Channel | null): void;
  close(): void;
}

export interface WriterLockOptions {
  /** The page's `navigator.locks`; null where there are none: then every page is a writer, and the storage refuses what doesn't fit. */
  readonly locks: Pick<LockManager, 'request'> | null;
  /** A channel between the pages that have this level open. */
  readonly channel: Channel | null;
  readonly timers: Timers;
  /** A name of the level that all pages use. */
  readonly name: string;
  /** Called before the level is handed to another page: writes what is unsaved. */
  readonly beforeHandOver: () => Promise<unknown>;
  /** What the writer has, for readers. */
  readonly onShown: (shown: Shown) => void;
  /** What this page has, for a reader that has just come. */
  readonly shown: () => Shown;
}

/** For so long a writer may take to write what it has before it is passed over, ms. */
const PATIENCE = 1500;

type Message = { readonly type: 'shown'; readonly shown: Shown } | { readonly type: 'hello' | 'hand-over' };

const isMessage = (data: unknown): data is Message =>
  typeof data === 'object' && data !== null && typeof (data as { type?: unknown }).type === 'string';

/** Asks to be the writer of a level, and becomes it when nobody else is, or as soon as the other one is gone. */
export function claimLevel(options: WriterLockOptions): WriterLock {
  const { locks, timers, beforeHandOver, onShown, shown } = options;
  let { name, channel } = options;
  const store = createStore<Role>(() => (locks === null ? 'writer' : 'waiting'));
  let letGo: (() => void) | null = null;
  /** Under the name before the last one. */
  let letGoOfOld = () => {};
  let waiting: AbortController | null = null;
  let cancelPatience = () => {};
  let isClosed = false;

  const become = (role: Role) => {
    if (!isClosed && store.getState() !== role) store.setState(role, true);
  };
  /** Holds the lock until it is let go of; resolves at once when this page is gone meanwhile. */
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
    // asks again behind the one who wanted it
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
      // a page that is frozen or has crashed does not answer
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
        // a page that holds the new name already has written nothing under it, so it is taken by force;
        // pages that wait for the old name must hear of the new one before the old one is released
        request({ steal: true });
        timers.after(2 * PATIENCE, release);
        return;
      }
      // the writer is to be there first
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
