import type { Contents, Entry } from '../io/index.ts';

/** A plain JSON object. */
export type Json = Readonly<Record<string, unknown>>;

/** What a thread does with the entries of a set. */
export interface Work {
  /** @returns what is recorded; the same for the same entry on every machine, except for time */
  work(entry: Entry): Json | Promise<Json>;
  /** Repeats what a record claims. @returns what it is in truth; null if it is as claimed */
  replay(entry: Entry, result: Json): string | null | Promise<string | null>;
}

/** A line of a result: what became of an entry. */
export interface ShardRecord {
  /** The number of the entry within the set, from 0. */
  readonly n: number;
  readonly file: string;
  /** The hash of its bytes. */
  readonly sha256: string;
  /** ms of wall time */
  readonly ms: number;
  readonly result: Json;
}

/** What can be done with a large set; each is the command of that name. */
export const JOBS = ['check', 'solve', 'difficulty', 'verify'] as const;

export type JobName = (typeof JOBS)[number];

/** What a set consists of that a job works on. */
export const contentsOf = (job: string): Contents => (job === 'verify' ? 'plays' : 'levels');
