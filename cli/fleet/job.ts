import type { Contents, Entry } from '../io/index.ts';

/** A plain JSON object. */
export type Json = Readonly<Record<string, unknown>>;

/** What has become of an entry. */
export interface Worked {
  /** ms of wall time */
  readonly ms: number;
  /** What is recorded; the same for the same entry on every machine, except for time. */
  readonly result: Json;
}

/** What a thread does with the entries of a set. */
export interface Work {
  /** @returns what has become of each entry, in their order */
  work(entries: readonly Entry[]): readonly Worked[] | Promise<readonly Worked[]>;
  /** Repeats what a record claims. @returns what it is in truth; null if it is as claimed */
  replay(entry: Entry, result: Json): string | null | Promise<string | null>;
}

/** Works on one entry after the other. */
export const oneByOne = (workOn: (entry: Entry) => Json | Promise<Json>): Work['work'] =>
  async function work(entries) {
    const all: Worked[] = [];
    for (const entry of entries) {
      const start = performance.now();
      const result = await workOn(entry);
      all.push({ ms: performance.now() - start, result });
    }
    return all;
  };

/** A line of a result: what became of an entry. */
export interface ShardRecord extends Worked {
  /** The number of the entry within the set, from 0. */
  readonly n: number;
  readonly file: string;
  /** The hash of its bytes. */
  readonly sha256: string;
}

/** Gives records in the order of their set, as often as it is called. `known` may give what stands for one by its line. */
export type Records = (known?: (line: string) => ShardRecord | null) => Iterable<ShardRecord>;

/** What can be done with a large set; each is the command of that name. */
export const JOBS = ['check', 'solve', 'difficulty', 'verify'] as const;

export type JobName = (typeof JOBS)[number];

/** What a set consists of that a job works on. */
export const contentsOf = (job: string): Contents => (job === 'verify' ? 'plays' : 'levels');
