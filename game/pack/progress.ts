import type { Best, PackStorage } from './types.ts';

/** The key of progress if the game names none. */
export const PROGRESS_KEY = 'gravity-quest-progress';

const VERSION = 1;

/** What is kept of a text that is not progress: this many under keys of their own. */
const MOST_KEPT = 20;

export const isBetter = (one: Best, other: Best): boolean =>
  one.minerals > other.minerals || (one.minerals === other.minerals && one.tick < other.tick);

const isCount = (value: unknown): value is number => typeof value === 'number' && Number.isSafeInteger(value) && value >= 0;

const isObject = (value: unknown): value is Readonly<Record<string, unknown>> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

export const isBest = (value: unknown): value is Best =>
  isObject(value) && isCount(value.tick) && isCount(value.minerals) && (value.play === null || typeof value.play === 'string');

/** What is read from the storage. `isWhole`: every entry was understood. */
interface Reading {
  readonly bests: Map<string, Best>;
  readonly isWhole: boolean;
}

function read(text: string | null): Reading {
  const bests = new Map<string, Best>();
  if (text === null) return { bests, isWhole: true };
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return { bests, isWhole: false };
  }
  if (!isObject(value) || value.version !== VERSION || !isObject(value.levels)) return { bests, isWhole: false };
  const entries = Object.entries(value.levels);
  for (const [id, entry] of entries)
    if (isBest(entry)) bests.set(id, { tick: entry.tick, minerals: entry.minerals, play: entry.play });
  return { bests, isWhole: bests.size === entries.length };
}

/** The best plays by the id of their level, in a storage that may be missing, full, or written by others. */
export class Progress {
  trouble: string | null = null;
  private readonly bests = new Map<string, Best>();

  constructor(
    private readonly storage: PackStorage | null,
    private readonly key: string,
  ) {
    this.merge();
  }

  best(id: string): Best | null {
    return this.bests.get(id) ?? null;
  }

  /** Keeps the best play of a level. @returns false if another tab has kept a better one */
  keep(id: string, { tick, minerals, play }: Best): boolean {
    const mine = { tick, minerals, play };
    const isOverwritable = this.merge();
    const theirs = this.best(id);
    if (theirs !== null && !isBetter(mine, theirs)) return false;
    this.bests.set(id, mine);
    if (isOverwritable) this.write();
    return true;
  }

  /** Takes what is better in the storage. @returns whether the storage may be overwritten without a loss */
  private merge(): boolean {
    const { storage, key } = this;
    if (storage === null) return false;
    let text: string | null;
    try {
      text = storage.getItem(key);
    } catch (error) {
      this.trouble = `Progress can't be read from the browser's storage: ${wordsOf(error)}.`;
      return false;
    }
    const { bests, isWhole } = read(text);
    for (const [id, theirs] of bests) {
      const mine = this.best(id);
      if (mine === null || isBetter(theirs, mine)) this.bests.set(id, theirs);
    }
    return isWhole || text === null || this.putAside(storage, text);
  }

  /** Keeps a text that is not progress, or not all of it, under another key. @returns whether it is kept */
  private putAside(storage: PackStorage, text: string): boolean {
    const { key } = this;
    try {
      for (let i = 1; i <= MOST_KEPT; i++) {
        const there = storage.getItem(`${key}.kept-${i}`);
        if (there === null) storage.setItem(`${key}.kept-${i}`, text);
        if (there === null || there === text) return true;
      }
      this.trouble = `Progress is not kept: ${key} in the browser's storage has been written by something else, time and again.`;
    } catch (error) {
      this.trouble = `Progress is not kept: ${key} in the browser's storage is not progress, and can't be put aside: ${wordsOf(error)}.`;
    }
    return false;
  }

  private write(): void {
    const levels = Object.fromEntries(this.bests);
    try {
      this.storage?.setItem(this.key, JSON.stringify({ version: VERSION, levels }));
      this.trouble = null;
    } catch (error) {
      this.trouble = `Progress lasts until this page is closed: the browser's storage takes nothing more: ${wordsOf(error)}.`;
    }
  }
}

const wordsOf = (error: unknown): string => (error instanceof Error ? error.message.replace(/\.$/, '') : String(error));
