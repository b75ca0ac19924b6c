import { createStore, type StoreApi } from 'zustand/vanilla';
import { formatLevel, type LevelFile, readLevel } from '../../schema/index.ts';
import { applyPatches, type EditedLevel, isSame, settle } from '../document/index.ts';
import type { JournalBase, JournalEntry, JournalStore, JournalWrite } from './journal-store.ts';
import { createMemoryStore } from './memory-store.ts';

/** Whether work is kept, for the person. */
export type JournalState =
  | { readonly kind: 'working' }
  /** Nothing outlives this page. */
  | { readonly kind: 'missing'; readonly message: string; readonly hint: string }
  /** The last changes could not be kept; it goes on trying with every change. */
  | { readonly kind: 'failing'; readonly message: string; readonly hint: string };

/** What was changed and never reached the disk. */
export interface Recovery {
  /** What the changes began with, and what the disk may have instead: whatever was on the way from there. */
  readonly base: { readonly file: LevelFile; readonly etag: string | null; readonly sent: readonly LevelFile[] };
  /** With all changes that could be read. */
  readonly file: LevelFile;
  /** Labels of the changes, the oldest first; those folded into one text are missing. */
  readonly labels: readonly string[];
  /** When the last one was made, ms since 1970. */
  readonly time: number;
  /** How many changes at the end could not be read. */
  readonly lost: number;
}

/** Whether what was done with a level would be there again if the page died now. `page`: it lives as long as the page, and no longer. */
export type Keeping = 'kept' | 'keeping' | 'failing' | 'page';

/** Keeps one level from now on. */
export interface LevelJournal {
  readonly keeping: StoreApi<Keeping>;
  /** This is on the disk under this etag: a file that the level had, or somebody else's. What led there need not be kept any longer. */
  onDisk(file: LevelFile, etag: string | null): void;
  /** This is about to be sent to the disk. Resolves when everything so far is kept, or could not be: then nothing on the disk is news to the journal. */
  onSent(file: LevelFile): Promise<void>;
  /** Resolves when everything so far is kept, or could not be. */
  settled(): Promise<void>;
  /** Stops following; what is kept stays. */
  close(): void;
}

export interface Journal {
  readonly state: StoreApi<JournalState>;
  /** The browser has a database after all: whoever follows a level recovers what it has, and follows anew. */
  adopt(store: JournalStore): void;
  /** Calls back when that has happened. @returns stops it */
  onAdopted(listener: () => void): () => void;
  /** What was left of a level; null when all of it reached the disk. Rejects when the database fails. */
  recover(place: string): Promise<Recovery | null>;
  /** All levels with changes that never reached the disk. Rejects when the database fails. */
  unsaved(): Promise<readonly { readonly place: string; readonly time: number }[]>;
  /**
   * Keeps every step of a level under a place, a name of the level in its folder.
   * What was kept of it before is replaced by what the level is now, so recover first.
   * @param base what is on the disk, or what of `sent`
   */
  follow(
    place: string,
    level: EditedLevel,
    base: { readonly file: LevelFile; readonly etag: string | null; readonly sent?: readonly LevelFile[] },
  ): LevelJournal;
  /** Forgets a level: the person has thrown its changes away. */
  forget(place: string): Promise<void>;
}

/** More entries than this are folded into one text. */
const MOST_ENTRIES = 200;
/** So many writes are on their way at most; what is done meanwhile is in the next one. */
const MOST_WRITES = 8;
/** After a write that failed all is written anew, ms. */
const RETRY = 3000;

function fileOf(text: string): LevelFile | null {
  const reading = readLevel(text);
  if (!reading.ok) return null;
  const settled = settle(reading.document.file, null);
  return settled.ok ? settled.file : null;
}

const isQuota = (error: unknown): boolean => error instanceof Error && error.name === 'QuotaExceededError';

function stateOf(error: unknown): JournalState {
  if (isQuota(error)) {
    return {
      kind: 'failing',
      message: 'the browser has no room left to keep your changes until they are saved',
      hint: 'save the level, free some space on the disk, or clear the data of other sites',
    };
  }
  const why = error instanceof Error ? error.message : String(error);
  return {
    kind: 'failing',
    message: `the browser could not keep your changes until they are saved: ${why}`,
    hint: 'save the level now',
  };
}

/** Applies entries as far as they go: each must follow the one before, and fit. */
function replay(start: LevelFile, first: number, entries: readonly JournalEntry[]): { files: LevelFile[]; labels: string[] } {
  let file = start;
  const files: LevelFile[] = [];
  const labels: string[] = [];
  for (const [i, { number, label, patches }] of entries.entries()) {
    if (number !== first + i) break;
    try {
      const next = settle(applyPatches(file, patches), null);
      if (!next.ok) break;
      file = next.file;
    } catch {
      break;
    }
    files.push(file);
    labels.push(label);
  }
  return { files, labels };
}

/** What is said where the page has no database. */
const MISSING = {
  message: 'this browser keeps no data of the page (a private window?), so changes that are not saved are lost with it',
  hint: 'download the level from time to time, or open the editor in an ordinary window',
};

/**
 * A journal of every step, so that a page that dies loses nothing.
 * @param store where it is kept; null where the browser has no database: then it says so, and keeps for as long as the page lives
 * @param now ms since 1970
 * @param after calls back after so many ms, and gives what takes the request back; null: a write that failed is tried with the next change alone
 * @param missing what is said where there is no store
 */
export function createJournal(
  store: JournalStore | null,
  now: () => number,
  after: ((ms: number, call: () => void) => () => void) | null = null,
  missing: { readonly message: string; readonly hint: string } = MISSING,
): Journal {
  let isLasting = store !== null;
  let kept = store ?? createMemoryStore();
  const state = createStore<JournalState>(() => (isLasting ? { kind: 'working' } : { ...missing, kind: 'missing' }));
  const listeners = new Set<() => void>();

  const freeRoom = async (except: string) => {
    for (const { place, entries } of await kept.places()) if (entries === 0 && place !== except) await kept.remove(place);
  };

  return {
    state,
    adopt(found) {
      if (isLasting) return;
      isLasting = true;
      kept = found;
      state.setState({ kind: 'working' }, true);
      for (const listener of [...listeners]) listener();
    },
    onAdopted(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
    async recover(place) {
      const found = await kept.read(place).catch((error) => {
        state.setState(stateOf(error), true);
        throw error;
      });
      if (found === null || (found.entries.length === 0 && found.tip === null)) return null;
      const base = fileOf(found.base.text);
      if (base === null) return null;
      const start = found.tip === null ? base : fileOf(found.tip.text);
      const first = found.tip === null ? (found.entries[0]?.number ?? 0) : found.tip.number + 1;
      const { files, labels } = start === null ? { files: [], labels: [] } : replay(start, first, found.entries);
      const lost = found.entries.length - labels.length + (start === null ? 1 : 0);
      const file = files.at(-1) ?? start ?? base;
      // a save may have been cut off after any step: what it wrote is this level's own
      const isFile = (read: LevelFile | null) => read !== null;
      const sent = [...(found.base.sent ?? []).map(fileOf), found.tip === null ? null : start, ...files].filter(isFile);
      return { base: { file: base, etag: found.base.etag, sent }, file, labels, time: found.time, lost };
    },
    async unsaved() {
      const found: { place: string; time: number }[] = [];
      for (const { place, time } of await kept.places()) {
        const level = await kept.read(place);
        if (level !== null && (level.entries.length > 0 || level.tip !== null)) found.push({ place, time });
      }
      return found;
    },
    forget: (place) => kept.remove(place),
    follow(place, level, first) {
      // what is followed stays where it began: who adopts another store follows anew
      const [to, lasts] = [kept, isLasting];
      let base = first;
      let current = level.settledFile();
      let number = 0;
      let entries: JournalEntry[] = [];
      /** Steps that are not on the disk, and which file each led to. */
      let since: { readonly number: number; readonly file: LevelFile }[] = [];
      let change: Partial<JournalWrite> = {};
      /** Writes on their way: they come to their ends in their order. */
      let flying = 0;
      /** Why the last write failed: nothing is written but all of it, once nothing is on its way. */
      let broken: { readonly error: unknown } | null = null;
      /** Something was done since all of it was tried last: worth another try. */
      let more = false;
      let isClosed = false;
      let cancelRetry = () => {};
      /** Steps up to this number are kept; up to this one they are, or could not be. */
      let safe = 0;
      let tried = 0;
      let waiting: { readonly upTo: number; readonly resolve: () => void }[] = [];
      let resting: (() => void)[] = [];
      const keeping = createStore<Keeping>(() => (lasts ? 'keeping' : 'page'));

      const works = () => {
        if (lasts && state.getState().kind !== 'working') state.setState({ kind: 'working' }, true);
      };
      const show = () => {
        if (!lasts) return;
        const now: Keeping = broken !== null ? 'failing' : safe >= number ? 'kept' : 'keeping';
        if (keeping.getState() !== now) keeping.setState(now, true);
      };
      const baseText = (): JournalBase => {
        const { file, etag, sent = [] } = base;
        return { text: formatLevel(file), etag, sent: sent.map((file) => formatLevel(file)) };
      };
      /** What is on the disk, and the whole text of what is not, in place of all steps. */
      const start = () => {
        const tip = isSame(base.file, current) ? null : { text: formatLevel(current), number };
        change = { base: baseText(), tip, dropUpTo: Number.MAX_SAFE_INTEGER };
        entries = [];
        since = tip === null ? [] : [{ number, file: current }];
      };
      /** Puts the whole text in place of many steps, and keeps which of them were sent. */
      const fold = () => {
        change = { ...change, base: baseText(), tip: { text: formatLevel(current), number }, dropUpTo: Number.MAX_SAFE_INTEGER };
        entries = [];
        since = since.slice(-1);
      };
      const over = (upTo: number) => {
        tried = Math.max(tried, upTo);
        for (const { upTo, resolve } of waiting) if (upTo <= tried) resolve();
        waiting = waiting.filter(({ upTo }) => upTo > tried);
      };
      const rested = () => {
        show();
        if (flying > 0) return;
        for (const resolve of resting) resolve();
        resting = [];
      };
      /** Sends what is to be written, and does not wait for what was sent before. */
      const send = async () => {
        const [add, rest, upTo] = [entries, change, number];
        entries = [];
        change = {};
        flying++;
        try {
          await to.write({ place, time: now(), ...rest, add });
          if (broken === null) safe = upTo;
        } catch (error) {
          broken ??= { error };
        }
        flying--;
        if (broken === null) {
          over(upTo);
          works();
          pump();
        } else if (flying === 0) await mend();
        rested();
      };
      /** All of it at once, in place of whatever of it is there. */
      const mend = async () => {
        const { error } = broken as { readonly error: unknown };
        const upTo = number;
        flying++;
        more = false;
        try {
          if (isQuota(error)) await freeRoom(place);
          start();
          const whole = change;
          change = {};
          await to.write({ place, time: now(), ...whole, add: [] });
          broken = null;
          safe = upTo;
          works();
        } catch (error) {
          broken = { error };
          state.setState(stateOf(error), true);
        }
        flying--;
        over(upTo);
        if (broken === null || more) pump();
        else if (!isClosed && after !== null) {
          cancelRetry();
          cancelRetry = after(RETRY, pump);
        }
        rested();
      };
      const pump = () => {
        if (broken !== null) {
          if (flying === 0) void mend();
          return;
        }
        while (flying < MOST_WRITES && (entries.length > 0 || Object.keys(change).length > 0)) void send();
      };
      const flush = () => {
        more = true;
        cancelRetry();
        pump();
        show();
      };

      const stop = level.onStep(({ label, patches, file }) => {
        current = file;
        entries.push({ number: ++number, label, patches });
        since.push({ number, file });
        if (since.length > MOST_ENTRIES) fold();
        flush();
      });
      start();
      flush();
      return {
        keeping,
        onSent(file) {
          const others = (base.sent ?? []).filter((other) => other !== file);
          base = { ...base, sent: [...others, file] };
          if (tried >= number) return Promise.resolve();
          const upTo = number;
          return new Promise((resolve) => waiting.push({ upTo, resolve }));
        },
        onDisk(file, etag) {
          base = { file, etag };
          const step = since.findLast((step) => step.file === file);
          if (step === undefined) start();
          else {
            since = since.filter((later) => later.number > step.number);
            entries = entries.filter((later) => later.number > step.number);
            const dropUpTo = Math.max(change.dropUpTo ?? 0, step.number);
            change = { ...change, base: baseText(), tip: null, dropUpTo };
          }
          flush();
        },
        async settled() {
          while (flying > 0) await new Promise<void>((resolve) => resting.push(resolve));
        },
        close() {
          isClosed = true;
          stop();
          cancelRetry();
        },
      };
    },
  };
}
