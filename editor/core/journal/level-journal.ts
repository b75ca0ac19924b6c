import { createStore, type StoreApi } from 'zustand/vanilla';
import { formatLevel, isSame, type LevelFile } from '../../../schema/index.ts';
import type { EditedLevel } from '../document/index.ts';
import {
  failureOf,
  isQuota,
  type JournalBase,
  type JournalEntry,
  type JournalState,
  type JournalStore,
  type JournalWrite,
} from './journal-store.ts';

/** Whether the changes of a level would survive if the page died now. `page`: they live only as long as the page. */
export type Keeping = 'kept' | 'keeping' | 'failing' | 'page';

/** Keeps one level. */
export interface LevelJournal {
  readonly keeping: StoreApi<Keeping>;
  /** This version is on disk under this etag, written by this page or others. Steps up to it need not be kept any longer. */
  onDisk(file: LevelFile, etag: string | null): void;
  /**
   * This version is about to be sent. Resolves when everything so far is kept or could not be, so that the disk never has
   * anything the journal does not know.
   */
  onSent(file: LevelFile): Promise<void>;
  /** Resolves when everything so far is kept or could not be. */
  settled(): Promise<void>;
  /** Stops following; what is kept stays. */
  close(): void;
}

/** more entries than this are replaced by one text */
const MOST_ENTRIES = 200;
/** largest number of writes in flight; later changes join the next write */
const MOST_WRITES = 8;
/** ms after a failed write until everything is written again */
const RETRY = 3000;

/** The state on disk: `file`, or one of `sent`. */
export interface DiskState {
  readonly file: LevelFile;
  readonly etag: string | null;
  readonly sent?: readonly LevelFile[];
}

/** Where and how a level is kept. */
export interface KeepingParts {
  readonly store: JournalStore;
  /** Whether the store outlives the page. */
  readonly isLasting: boolean;
  /** The state of the whole journal. */
  readonly state: StoreApi<JournalState>;
  /** ms since 1970 */
  readonly now: () => number;
  /** Calls back after `ms`. @returns cancels it */
  readonly after: ((ms: number, call: () => void) => () => void) | null;
  /** Deletes the data of levels that are saved, except for one. */
  readonly freeRoom: (except: string) => Promise<void>;
}

/** Keeps every step of a level under a place. @param base the state on disk */
export const keepLevel = (place: string, level: EditedLevel, base: DiskState, parts: KeepingParts): LevelJournal =>
  new KeptSteps(place, level, base, parts);

class KeptSteps implements LevelJournal {
  readonly keeping: StoreApi<Keeping>;
  private current: LevelFile;
  /** number of the last step */
  private number = 0;
  private entries: JournalEntry[] = [];
  /** Steps that are not on disk, and the file that each led to. */
  private since: { readonly number: number; readonly file: LevelFile }[] = [];
  private change: Partial<JournalWrite> = {};
  /** Writes in flight; they finish in order. */
  private flying = 0;
  /** Why the last write failed: then the whole state is written, once nothing is in flight. */
  private broken: { readonly error: unknown } | null = null;
  /** Whether something changed since the whole state was last tried, which makes another try worthwhile. */
  private more = false;
  private isClosed = false;
  private cancelRetry = () => {};
  /** `safe`: steps up to this number are kept. `tried`: steps up to this number are kept or could not be. */
  private safe = 0;
  private tried = 0;
  private waiting: { readonly upTo: number; readonly resolve: () => void }[] = [];
  private resting: (() => void)[] = [];
  private readonly stop: () => void;

  constructor(
    private readonly place: string,
    level: EditedLevel,
    private base: DiskState,
    private readonly parts: KeepingParts,
  ) {
    this.current = level.committedFile();
    this.keeping = createStore<Keeping>(() => (parts.isLasting ? 'keeping' : 'page'));
    this.stop = level.onStep(({ label, patches, file }) => {
      this.current = file;
      this.entries.push({ number: ++this.number, label, patches });
      this.since.push({ number: this.number, file });
      if (this.since.length > MOST_ENTRIES) this.fold();
      this.flush();
    });
    this.begin();
    this.flush();
  }

  onSent(file: LevelFile): Promise<void> {
    const others = (this.base.sent ?? []).filter((other) => other !== file);
    this.base = { ...this.base, sent: [...others, file] };
    if (this.tried >= this.number) return Promise.resolve();
    const upTo = this.number;
    return new Promise((resolve) => this.waiting.push({ upTo, resolve }));
  }

  onDisk(file: LevelFile, etag: string | null): void {
    this.base = { file, etag };
    const step = this.since.findLast((one) => one.file === file);
    if (step === undefined) this.begin();
    else {
      this.since = this.since.filter((later) => later.number > step.number);
      this.entries = this.entries.filter((later) => later.number > step.number);
      const dropUpTo = Math.max(this.change.dropUpTo ?? 0, step.number);
      this.change = { ...this.change, base: this.baseText(), tip: null, dropUpTo };
    }
    this.flush();
  }

  async settled(): Promise<void> {
    while (this.flying > 0) await new Promise<void>((resolve) => this.resting.push(resolve));
  }

  close(): void {
    this.isClosed = true;
    this.stop();
    this.cancelRetry();
  }

  private baseText(): JournalBase {
    const { file, etag, sent = [] } = this.base;
    return { text: formatLevel(file), etag, sent: sent.map((one) => formatLevel(one)) };
  }

  /** Replaces all steps by the state on disk and the full text of the level if it differs. */
  private begin(): void {
    const { current, number } = this;
    const tip = isSame(this.base.file, current) ? null : { text: formatLevel(current), number };
    this.change = { base: this.baseText(), tip, dropUpTo: Number.MAX_SAFE_INTEGER };
    this.entries = [];
    this.since = tip === null ? [] : [{ number, file: current }];
  }

  /** Replaces many steps by the full text, and remembers which of them were sent. */
  private fold(): void {
    const tip = { text: formatLevel(this.current), number: this.number };
    this.change = { ...this.change, base: this.baseText(), tip, dropUpTo: Number.MAX_SAFE_INTEGER };
    this.entries = [];
    this.since = this.since.slice(-1);
  }

  private flush(): void {
    this.more = true;
    this.cancelRetry();
    this.pump();
    this.show();
  }

  /** Writes pending changes, as far as the limit of writes in flight allows. */
  private pump(): void {
    if (this.broken !== null) {
      if (this.flying === 0) void this.rewrite();
      return;
    }
    while (this.flying < MOST_WRITES && (this.entries.length > 0 || Object.keys(this.change).length > 0)) void this.send();
  }

  /** Sends pending changes without waiting for earlier writes. */
  private async send(): Promise<void> {
    const { entries, change, number: upTo, place, parts } = this;
    this.entries = [];
    this.change = {};
    this.flying++;
    try {
      await parts.store.write({ place, time: parts.now(), ...change, add: entries });
      if (this.broken === null) this.safe = upTo;
    } catch (error) {
      this.broken ??= { error };
    }
    this.flying--;
    if (this.broken === null) {
      this.over(upTo);
      this.showWorks();
      this.pump();
    } else if (this.flying === 0) await this.rewrite();
    this.rested();
  }

  /** Writes the whole state, replacing whatever is stored. */
  private async rewrite(): Promise<void> {
    const { place, parts, number: upTo } = this;
    const { error } = this.broken as { readonly error: unknown };
    this.flying++;
    this.more = false;
    try {
      if (isQuota(error)) await parts.freeRoom(place);
      this.begin();
      const whole = this.change;
      this.change = {};
      await parts.store.write({ place, time: parts.now(), ...whole, add: [] });
      this.broken = null;
      this.safe = upTo;
      this.showWorks();
    } catch (failure) {
      this.broken = { error: failure };
      parts.state.setState(failureOf(failure), true);
    }
    this.flying--;
    this.over(upTo);
    if (this.broken === null || this.more) this.pump();
    else if (!this.isClosed && parts.after !== null) {
      this.cancelRetry();
      this.cancelRetry = parts.after(RETRY, () => this.pump());
    }
    this.rested();
  }

  /** Steps up to a number are kept or could not be. */
  private over(upTo: number): void {
    this.tried = Math.max(this.tried, upTo);
    for (const { upTo, resolve } of this.waiting) if (upTo <= this.tried) resolve();
    this.waiting = this.waiting.filter(({ upTo }) => upTo > this.tried);
  }

  private rested(): void {
    this.show();
    if (this.flying > 0) return;
    for (const resolve of this.resting) resolve();
    this.resting = [];
  }

  private showWorks(): void {
    const { isLasting, state } = this.parts;
    if (isLasting && state.getState().kind !== 'working') state.setState({ kind: 'working' }, true);
  }

  private show(): void {
    if (!this.parts.isLasting) return;
    const now: Keeping = this.broken !== null ? 'failing' : this.safe >= this.number ? 'kept' : 'keeping';
    if (this.keeping.getState() !== now) this.keeping.setState(now, true);
  }
}
