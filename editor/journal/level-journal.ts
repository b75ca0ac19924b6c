import { createStore, type StoreApi } from 'zustand/vanilla';
import { formatLevel, type LevelFile } from '../../schema/index.ts';
import { type EditedLevel, isSame } from '../document/index.ts';
import { failureOf, isQuota, type JournalState } from './journal-state.ts';
import type { JournalBase, JournalEntry, JournalStore, JournalWrite } from './journal-store.ts';

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

/** More entries than this are folded into one text. */
const MOST_ENTRIES = 200;
/** So many writes are on their way at most; what is done meanwhile is in the next one. */
const MOST_WRITES = 8;
/** After a write that failed all is written anew, ms. */
const RETRY = 3000;

/** What is on the disk, or what of `sent`. */
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
  /** How the whole journal stands. */
  readonly state: StoreApi<JournalState>;
  /** ms since 1970 */
  readonly now: () => number;
  /** Calls back after so many ms. @returns takes it back */
  readonly after: ((ms: number, call: () => void) => () => void) | null;
  /** Throws away what is kept of levels that are saved, but for one. */
  readonly freeRoom: (except: string) => Promise<void>;
}

/** Keeps every step of a level under a place from now on. @param base what is on the disk */
export const keepLevel = (place: string, level: EditedLevel, base: DiskState, parts: KeepingParts): LevelJournal =>
  new KeptSteps(place, level, base, parts);

class KeptSteps implements LevelJournal {
  readonly keeping: StoreApi<Keeping>;
  private current: LevelFile;
  /** Of the last step. */
  private number = 0;
  private entries: JournalEntry[] = [];
  /** Steps that are not on the disk, and which file each led to. */
  private since: { readonly number: number; readonly file: LevelFile }[] = [];
  private change: Partial<JournalWrite> = {};
  /** Writes on their way: they come to their ends in their order. */
  private flying = 0;
  /** Why the last write failed: nothing is written but all of it, once nothing is on its way. */
  private broken: { readonly error: unknown } | null = null;
  /** Something was done since all of it was tried last: worth another try. */
  private more = false;
  private isClosed = false;
  private cancelRetry = () => {};
  /** Steps up to this number are kept; up to this one they are, or could not be. */
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
    this.current = level.settledFile();
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

  /** What is on the disk, and the whole text of what is not, in place of all steps. */
  private begin(): void {
    const { current, number } = this;
    const tip = isSame(this.base.file, current) ? null : { text: formatLevel(current), number };
    this.change = { base: this.baseText(), tip, dropUpTo: Number.MAX_SAFE_INTEGER };
    this.entries = [];
    this.since = tip === null ? [] : [{ number, file: current }];
  }

  /** Puts the whole text in place of many steps, and keeps which of them were sent. */
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

  /** Writes what is to be written, as far as writes may be on their way. */
  private pump(): void {
    if (this.broken !== null) {
      if (this.flying === 0) void this.mend();
      return;
    }
    while (this.flying < MOST_WRITES && (this.entries.length > 0 || Object.keys(this.change).length > 0)) void this.send();
  }

  /** Sends what is to be written, and does not wait for what was sent before. */
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
    } else if (this.flying === 0) await this.mend();
    this.rested();
  }

  /** All of it at once, in place of whatever of it is there. */
  private async mend(): Promise<void> {
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

  /** Steps up to a number are kept, or could not be. */
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
