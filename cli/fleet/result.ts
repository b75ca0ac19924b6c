import { createHash, type Hash } from 'node:crypto';
import { linkSync, renameSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { LineWriter } from '../io/index.ts';
import { Failure, namedPath } from '../terminal/index.ts';
import { entryHash, ShardDigest } from './digest.ts';
import type { ShardRecord } from './job.ts';
import { LineReader } from './line-reader.ts';
import type { Plan } from './plan.ts';

const RESULT_VERSION = 1;

/** The first line of a result. */
export interface Header {
  readonly gq: 'shard';
  readonly version: typeof RESULT_VERSION;
  /** The seal of the plan. */
  readonly plan: string;
  readonly job: string;
  readonly shard: number;
  readonly shards: number;
  readonly engine: string;
  readonly code: string;
}

/** The last line of a result. */
interface Trailer {
  readonly gq: 'end';
  readonly levels: number;
  /** The hash of all records without times: the same wherever the shard has run. */
  readonly records: string;
  /** The hash of all bytes before this line: a torn or changed file has another. */
  readonly sha256: string;
}

/** The name of the result of a shard. */
export const resultName = (shard: number): string => `shard-${shard}.ndjson`;

/** The names of results, and of others of the same shard that differ from it. */
export const RESULT_FILE = /^shard-(\d{1,6})(?:\.differs-\d+)?\.ndjson$/;

export const headerOf = ({ seal, job, engine, code, shards }: Plan, shard: number): Header => ({
  gq: 'shard',
  version: RESULT_VERSION,
  plan: seal,
  job,
  shard,
  shards: shards.length,
  engine,
  code,
});

/** The time that a record took, as it stands in its line. */
const TIME = /,"ms":[-+.e\d]+,"result":/;

/** The hash of records without the times that they took. */
export class RecordsHash {
  private readonly hash: Hash = createHash('sha256');

  add(line: string | Buffer): void {
    this.hash.update(String(line).trimEnd().replace(TIME, ',"result":')).update('\n');
  }

  end(): string {
    return this.hash.digest('hex');
  }
}

/** Writes the result of a shard. Methods throw system errors. */
export class ResultWriter {
  private readonly out: LineWriter;
  private readonly bytes = createHash('sha256');
  private readonly records = new RecordsHash();
  private levels = 0;

  constructor(
    private readonly path: string,
    header: Header,
  ) {
    this.out = new LineWriter(path);
    this.put(`${JSON.stringify(header)}\n`);
  }

  add(line: string): void {
    this.levels++;
    this.records.add(line);
    this.put(line);
  }

  /** Completes the file under its temporary name. @returns the hash of its records */
  end(): string {
    const records = this.records.end();
    const trailer: Trailer = { gq: 'end', levels: this.levels, records, sha256: this.bytes.digest('hex') };
    this.out.write(`${JSON.stringify(trailer)}\n`);
    this.out.end();
    return records;
  }

  /** Moves the file to its place, or to another one. @returns false if there is a file already and it is to stay */
  place(path: string = this.path, replaces = false): boolean {
    if (replaces) {
      renameSync(this.out.unfinished, path);
      return true;
    }
    try {
      linkSync(this.out.unfinished, path);
      return true;
    } catch (error) {
      const code = (error as NodeJS.ErrnoException).code ?? '';
      if (code === 'EEXIST') return false;
      // a file system without hard links
      if (statSync(path, { throwIfNoEntry: false }) !== undefined) return false;
      renameSync(this.out.unfinished, path);
      return true;
    }
  }

  discard(): void {
    this.out.discard();
  }

  private put(text: string): void {
    this.bytes.update(text);
    this.out.write(text);
  }
}

/** What is in a result. */
export type Inspected =
  | {
      readonly state: 'complete';
      readonly levels: number;
      /** The hash over its levels, as a plan has it. */
      readonly set: string;
      readonly records: string;
    }
  /** A result of another plan, or no result at all: why. */
  | { readonly state: 'foreign'; readonly why: string }
  /** Cut off or changed: why. */
  | { readonly state: 'damaged'; readonly why: string };

const isHeader = (value: unknown): value is Header =>
  typeof value === 'object' && value !== null && (value as Header).gq === 'shard' && typeof (value as Header).plan === 'string';

/**
 * Reads a result to its end and checks that it is whole and of a plan.
 * @throws NotAFile, and system errors
 */
export function inspect(path: string, expected: Header): Inspected {
  const reader = new LineReader(path);
  const first = reader.next();
  const header = first === null ? null : parsed(first);
  // only what can be the begin of this result is a damaged one; anything else is not to be replaced
  if (first === null && isBegin(reader.unended, expected)) return { state: 'damaged', why: 'it is cut off in its first line' };
  if (!isHeader(header)) return { state: 'foreign', why: 'it does not begin as a result of a shard' };
  const foreign = foreignHeader(header, expected);
  if (foreign !== null) return { state: 'foreign', why: foreign };
  const bytes = createHash('sha256').update(first!).update('\n');
  const records = new RecordsHash();
  const set = new ShardDigest();
  for (let line = reader.next(); line !== null; line = reader.next()) {
    if (line.length < 400 && line.indexOf('{"gq":"end"') === 0) {
      const trailer = parsed(line) as Trailer | null;
      const hash = bytes.digest('hex');
      if (reader.next() !== null || reader.unended.length > 0)
        return { state: 'damaged', why: 'something follows its last line' };
      if (trailer?.sha256 !== hash || trailer.levels !== set.entries || trailer.records !== records.end())
        return { state: 'damaged', why: 'its checksum is wrong: it has been changed or damaged' };
      return { state: 'complete', levels: set.entries, set: set.end(), records: trailer.records };
    }
    bytes.update(line).update('\n');
    records.add(line);
    addTo(set, line);
  }
  return { state: 'damaged', why: 'it is cut off: its last line is missing' };
}

const isBegin = (bytes: Buffer, header: Header): boolean =>
  Buffer.from(JSON.stringify(header)).subarray(0, bytes.length).equals(bytes);

const RECORD = /^\{"n":(\d+),"file":("(?:[^"\\]|\\.)*"),"sha256":"([0-9a-f]{64})","ms":([-+.e\d]+),"result":(\{.*\})\}$/s;

function addTo(set: ShardDigest, line: Buffer): void {
  const [, n, quoted, sha256] = RECORD.exec(line.toString('utf8')) ?? [];
  const file = quoted === undefined ? null : parsed(quoted);
  // a line that is no record makes the hash of the set another
  if (typeof file !== 'string') set.add(-1, line);
  else set.add(Number(n), entryHash(Buffer.from(sha256, 'hex'), file));
}

function foreignHeader(found: Header, expected: Header): string | null {
  if (found.version !== expected.version) return `expected a result of version ${expected.version}, found ${found.version}`;
  if (found.engine !== expected.engine) return `expected a result of engine ${expected.engine}, found one of ${found.engine}`;
  if (found.code !== expected.code)
    return `expected a result of code ${expected.code.slice(0, 12)}, found one of ${String(found.code).slice(0, 12)}`;
  if (found.plan !== expected.plan) return 'it belongs to another plan';
  return found.shard === expected.shard ? null : `expected shard ${expected.shard}, found shard ${found.shard}`;
}

function parsed(line: Buffer | string): unknown {
  try {
    return JSON.parse(line.toString());
  } catch {
    return null;
  }
}

/**
 * Takes a record apart as it was written: a JSON reader would take the last of two values for the same key, and so another level
 * than the one that was counted.
 * @throws Failure if it was written by something else
 */
export function recordOfLine(line: Buffer): ShardRecord {
  const [, n, file, sha256, ms, result] = RECORD.exec(line.toString()) ?? [];
  try {
    return { n: Number(n), file: JSON.parse(file), sha256, ms: Number(ms), result: JSON.parse(result) };
  } catch {
    throw new Failure(
      `the record of ${namedPath(String(file ?? line.toString('utf8', 0, 80)))} was changed: it is not as gq writes it`,
    );
  }
}

/** Where the result of a shard is. */
export const resultPath = (folder: string, shard: number): string => join(folder, resultName(shard));
