import { createStore, get, update } from 'idb-keyval';
import { createJournal, openIndexedDbStore } from '../journal/index.ts';
import { createBrowserStorage, type KeyValues } from './browser-storage.ts';
import type { Surroundings } from './open-level.ts';
import { createServerStorage } from './server-storage.ts';
import { pageTimers } from './timers.ts';
import type { Channel } from './writer-lock.ts';

const TOKEN = 'gravity-quest-editor-token';

/** The token in the address that `gq edit` prints; kept for this tab, so that the page can be loaded anew. null: the page comes from a plain web server. */
function tokenOf(page: Window): string | null {
  const found = new URLSearchParams(page.location.hash.slice(1)).get('token');
  try {
    if (found !== null) page.sessionStorage.setItem(TOKEN, found);
    return found ?? page.sessionStorage.getItem(TOKEN);
  } catch {
    // a browser that keeps nothing: the address has it
    return found;
  }
}

/** Levels kept in the browser's database, or for as long as the page lives where it has none. */
function browserValues(hasDatabase: boolean): KeyValues {
  if (hasDatabase) {
    const store = createStore('gravity-quest-editor-levels', 'levels');
    return { get: (key) => get(key, store), update: (key, change) => update(key, change, store) };
  }
  const values = new Map<string, unknown>();
  return {
    get: async (key) => values.get(key),
    async update(key, change) {
      values.set(key, change(values.get(key)));
    },
  };
}

const channelTo = (name: string): Channel | null => (typeof BroadcastChannel === 'undefined' ? null : new BroadcastChannel(name));

/** What a page of the browser offers: levels behind `gq edit` when it was opened by its address, else in the browser. */
export async function pageSurroundings(page: Window): Promise<Omit<Surroundings, 'folder'>> {
  const token = tokenOf(page);
  const kept = await openIndexedDbStore(indexedDB).catch(() => null);
  const storage =
    token !== null
      ? createServerStorage({ origin: page.location.origin, token, client: crypto.randomUUID(), fetch: page.fetch.bind(page) })
      : createBrowserStorage(browserValues(kept !== null), channelTo('gravity-quest-editor-levels'), Date.now);
  return {
    storage,
    journal: createJournal(kept, Date.now),
    timers: pageTimers,
    locks: page.navigator.locks ?? null,
    channel: channelTo,
  };
}
