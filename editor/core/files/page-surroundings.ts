import { get, update } from 'idb-keyval';
import { EDIT_API, EDIT_ERRORS } from '../../../schema/index.ts';
import { whenIdle } from '../ask/index.ts';
import { type AttemptKeeper, createAttemptKeeper, openIndexedDbAttempts } from '../attempts/index.ts';
import { openDatabase } from '../database/index.ts';
import { createJournal, openIndexedDbStore } from '../journal/index.ts';
import { createVersionKeeper, openIndexedDbVersions } from '../versions/index.ts';
import { createBrowserStorage, type KeyValues } from './browser-storage.ts';
import type { LevelStorage } from './level-storage.ts';
import type { Surroundings } from './open-level.ts';
import { createPageKey, mayBeServed, takeToken } from './page-access.ts';
import { createServerStorage } from './server-storage.ts';
import { pageTimers, type Timers } from './timers.ts';
import type { Channel } from './writer-lock.ts';

/** ms that the page waits for a database before it starts without it */
const PATIENCE = 3000;
/** ms between attempts to open a database that was refused */
const RETRY = 30_000;

const LEVELS = 'gravity-quest-editor-levels';

/** What the page provides, whether or not its database answers. */
export interface PageSurroundings extends Omit<Surroundings, 'folder'> {
  readonly attempts: AttemptKeeper;
  /** Levels of this browser that became readable only after the page had started without them; null if it started with them. */
  readonly lateLevels: Promise<LevelStorage> | null;
}

/**
 * Opens something, again and again while that fails. @returns the value if it arrives in time, else null; and a promise of the
 * value
 */
export async function inTimeOrLate<T>(
  open: () => Promise<T>,
  timers: Pick<Timers, 'after'>,
): Promise<{ readonly inTime: T | null; readonly late: Promise<T> }> {
  let answered = (_: T | null) => {};
  const first = new Promise<T | null>((resolve) => {
    answered = resolve;
  });
  const cancel = timers.after(PATIENCE, () => answered(null));
  const late = (async () => {
    for (;;) {
      try {
        const value = await open();
        answered(value);
        return value;
      } catch {
        answered(null);
        await new Promise<void>((resolve) => timers.after(RETRY, resolve));
      }
    }
  })();
  const inTime = await first;
  cancel();
  return { inTime, late };
}

/** The levels in the browser's database. */
async function openValues(databases: IDBFactory, timers: Timers): Promise<KeyValues> {
  const database = await openDatabase({ databases, name: LEVELS, stores: { levels: null }, after: timers.after });
  const use = <T>(mode: IDBTransactionMode, work: (store: IDBObjectStore) => T | PromiseLike<T>): Promise<T> =>
    database.within(mode, async (stores) => work(stores('levels')));
  return { get: (key) => get(key, use), update: (key, change) => update(key, change, use) };
}

/** Levels that live only as long as the page. */
function passingValues(): KeyValues {
  const values = new Map<string, unknown>();
  return {
    get: async (key) => values.get(key),
    async update(key, change) {
      values.set(key, change(values.get(key)));
    },
  };
}

const channelTo = (name: string): Channel | null => (typeof BroadcastChannel === 'undefined' ? null : new BroadcastChannel(name));

/** Whether `gq edit` serves this page although it was opened without its token: by a bookmark, or an address typed by hand. */
async function isServed(page: Window): Promise<boolean> {
  if (!mayBeServed(page)) return false;
  try {
    const { status } = await page.fetch(EDIT_API.LEVELS, { cache: 'no-store', signal: AbortSignal.timeout(PATIENCE) });
    return status === EDIT_ERRORS['wrong-token'];
  } catch {
    return false;
  }
}

/** The levels of this browser; only those of this page while the database does not answer. */
async function browserLevels(timers: Timers): Promise<{ storage: LevelStorage; lateLevels: Promise<LevelStorage> | null }> {
  const over = (values: KeyValues, lasts: boolean) =>
    createBrowserStorage(values, lasts ? channelTo(LEVELS) : null, Date.now, lasts);
  const { inTime, late } = await inTimeOrLate(() => openValues(indexedDB, timers), timers);
  if (inTime !== null) return { storage: over(inTime, true), lateLevels: null };
  return { storage: over(passingValues(), false), lateLevels: late.then((values) => over(values, true)) };
}

/** How long a version may wait until it is recorded, ms. */
const BEFORE_RECORDED = { longest: 2000, untold: 500 };

/** What the page provides: the levels behind `gq edit` if it comes from there, else those of the browser. */
export async function pageSurroundings(page: Window): Promise<PageSurroundings> {
  const timers = pageTimers;
  const given = takeToken(page);
  const opening = inTimeOrLate(() => openIndexedDbStore(indexedDB, timers.after), timers);
  const openingAttempts = inTimeOrLate(() => openIndexedDbAttempts(indexedDB, timers.after), timers);
  const openingVersions = inTimeOrLate(() => openIndexedDbVersions(indexedDB, timers.after), timers);
  const key = createPageKey({
    location: page.location,
    crypto: page.crypto,
    fetch: page.fetch.bind(page),
    // the browser may refuse access only when it is used
    get sessionStorage() {
      return page.sessionStorage;
    },
  });
  // with an empty token, the storage reports what is missing
  const token = given ?? ((await isServed(page)) ? '' : null);
  const levels =
    token === null
      ? await browserLevels(timers)
      : {
          storage: createServerStorage({
            origin: page.location.origin,
            token,
            key,
            client: crypto.randomUUID(),
            fetch: page.fetch.bind(page),
          }),
          lateLevels: null,
        };
  const { inTime, late } = await opening;
  const journal = createJournal(inTime, Date.now, timers.after);
  if (inTime === null) void late.then((store) => journal.adopt(store));
  const found = await openingVersions;
  const versions = createVersionKeeper({
    store: found.inTime,
    now: Date.now,
    whenIdle: (call) => whenIdle(BEFORE_RECORDED, call),
  });
  if (found.inTime === null) void found.late.then((store) => versions.adopt(store));
  const made = await openingAttempts;
  const attempts = createAttemptKeeper(made.inTime, timers.after);
  if (made.inTime === null) void made.late.then((store) => attempts.adopt(store));
  return { ...levels, attempts, journal, versions, timers, locks: page.navigator.locks ?? null, channel: channelTo };
}
