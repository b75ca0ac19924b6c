import { createHash } from 'node:crypto';
import { readdirSync, rmdirSync, rmSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { makeFolders, readRegularFile, replaceSpareFile, UNFINISHED } from '../io/index.ts';
import { uncut } from '../terminal/index.ts';

// Records are spread over a few files, the shards, by the first digit of their keys: reading a thousand small files takes
// longer than the work that they save. A shard is replaced as a whole. When two processes replace it at once, the later one
// wins, and what the other one has added is computed anew some day.
//
// A shard has its records in the order of their last use, as far as is known: the ones that were used or added by the process
// that wrote it come first. So the last ones are dropped when it gets too large, and no clock is needed.

/** The size to which unused records may fill a shard, bytes. */
const SHARD_SIZE = 4 * 1024 * 1024;

/** A shard of more than this is not read, bytes: no check has written it. */
const LARGEST_SHARD = 1024 * 1024 * 1024;

/** A longer text is not kept, characters. */
const LONGEST_TEXT = 1024 * 1024;

/** ms; an unfinished file that is older belongs to a process that was killed */
const LONG_AGO = 3_600_000;

/** Texts by keys of 64 digits, kept in a folder from one process to the next. Trouble with the folder is never an error. */
export interface Store {
  /** The text of a key; null if there is none, or if it is damaged. */
  get(key: string): string | null;
  /** @param text has no line breaks */
  put(key: string, text: string): void;
  /** Whether there are no records at all. */
  isEmpty(): boolean;
  /** Writes what has been put, unless a signal ends the process before. */
  save(): Promise<void>;
}

/** @param shardSize the size to which unused records may fill a shard, bytes */
export function openStore(folder: string, shardSize: number = SHARD_SIZE): Store {
  const shards = new Map<string, Map<string, RecordLine>>();
  const shardOf = (digit: string): Map<string, RecordLine> => {
    const known = shards.get(digit);
    if (known !== undefined) return known;
    const read = readShard(folder, digit);
    shards.set(digit, read);
    return read;
  };
  const used = new Map<string, RecordLine>();
  const changed = new Set<string>();
  return {
    get(key) {
      const line = used.get(key) ?? shardOf(key[0]).get(key);
      const text = line === undefined ? null : textOf(line, key);
      if (line !== undefined && text !== null) used.set(key, line);
      return text;
    },
    put(key, text) {
      if (text.length > LONGEST_TEXT) return;
      used.set(key, makeRecord(key, text));
      changed.add(key[0]);
    },
    isEmpty: () => DIGITS.every((digit) => shardOf(digit).size === 0),
    async save() {
      if (changed.size === 0) return;
      const digits = [...changed].sort();
      changed.clear();
      // a signal ends the process between any two of these
      const isNew = await uncut(() => makeFolder(folder));
      if (isNew) for (const [name, text] of MARKS) await uncut(() => replaceIfPossible(join(folder, name), Buffer.from(text)));
      await uncut(() => removeUnfinished(folder));
      for (const digit of digits) {
        const ours = [...used].filter(([key]) => key.startsWith(digit));
        await uncut(() => writeShard(folder, digit, ours, shardSize));
      }
    },
  };
}

const DIGITS = [...'0123456789abcdef'];

const shardPath = (folder: string, digit: string): string => join(folder, `check-${digit}`);

function readShard(folder: string, digit: string): Map<string, RecordLine> {
  try {
    return splitShard(readRegularFile(shardPath(folder, digit), LARGEST_SHARD));
  } catch {
    // no cache yet, or one that can't be read: as good as an empty one
    return new Map();
  }
}

/** Keeps a new folder out of repositories and backups. */
const MARKS = [
  ['.gitignore', '*\n'],
  ['CACHEDIR.TAG', 'Signature: 8a477f597d28d172789f06886806bc55\n# The cache of gq check. It can be deleted at any time.\n'],
] as const;

/** Whether the folder was made; false if it is there already, or can't be made. */
function makeFolder(folder: string): boolean {
  try {
    return makeFolders(folder) !== undefined;
  } catch {
    return false;
  }
}

/** Removes what killed processes have left. */
function removeUnfinished(folder: string): void {
  try {
    for (const name of readdirSync(folder)) {
      const path = join(folder, name);
      if (UNFINISHED.test(name) && Date.now() - statSync(path).mtimeMs > LONG_AGO) rmSync(path, { force: true });
    }
  } catch {
    // there is no folder, or another process is faster
  }
}

/** A file that can't be written is not kept: the folder may be missing, read-only or full, or something else has the name. */
function replaceIfPossible(path: string, bytes: Uint8Array): void {
  try {
    if (statSync(path, { throwIfNoEntry: false })?.isDirectory()) rmdirSync(path);
    replaceSpareFile(path, bytes);
  } catch {
    // as if there were no cache
  }
}

function writeShard(folder: string, digit: string, ours: readonly (readonly [string, RecordLine])[], shardSize: number): void {
  const path = shardPath(folder, digit);
  const lines = new Map(ours);
  let size = ours.reduce((sum, [, line]) => sum + line.length, 0);
  // read again, as another process may have added records
  for (const [key, line] of readShard(folder, digit)) {
    if (lines.has(key)) continue;
    size += line.length;
    if (size > shardSize) break;
    if (textOf(line, key) !== null) lines.set(key, line);
  }
  replaceIfPossible(path, joinShard(lines.values()));
}

// A shard is a text of lines. The first names the format. Each other one is a record: key, checksum of key and text, text. A
// text is JSON, so it has no line breaks. Whatever happens to the bytes of a shard, a record is used only if its checksum is
// right, so damage costs no more than the records that it touches.

const FORMAT = Buffer.from('gq cache 1\n');
const KEY_DIGITS = 64;
const CHECK_DIGITS = 32;
const TEXT_AT = KEY_DIGITS + 1 + CHECK_DIGITS + 1;
const NEWLINE = 0x0a;

/** A line of a shard, with its line break. */
type RecordLine = Uint8Array;

const checksum = (key: string, text: string | Uint8Array): string =>
  createHash('sha256').update(key).update(text).digest('hex').slice(0, CHECK_DIGITS);

/** @param text has no line breaks */
const makeRecord = (key: string, text: string): RecordLine => Buffer.from(`${key} ${checksum(key, text)} ${text}\n`);

/** The text of a record; null if the record is damaged, or made for another key. */
function textOf(line: RecordLine, key: string): string | null {
  const bytes = Buffer.from(line.buffer, line.byteOffset, line.byteLength);
  const text = bytes.subarray(TEXT_AT, -1);
  return bytes.toString('latin1', 0, TEXT_AT) === `${key} ${checksum(key, text)} ` ? text.toString() : null;
}

/** The records of a shard by their keys, in their order, damaged ones included; none if the bytes are no shard. */
function splitShard(bytes: Uint8Array): Map<string, RecordLine> {
  const shard = Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const lines = new Map<string, RecordLine>();
  if (!shard.subarray(0, FORMAT.length).equals(FORMAT)) return lines;
  for (let start = FORMAT.length; start < shard.length; ) {
    const end = shard.indexOf(NEWLINE, start);
    // the last line of a torn file
    if (end < 0) break;
    if (end - start >= TEXT_AT) lines.set(shard.toString('latin1', start, start + KEY_DIGITS), shard.subarray(start, end + 1));
    start = end + 1;
  }
  return lines;
}

const joinShard = (lines: Iterable<RecordLine>): Uint8Array => Buffer.concat([FORMAT, ...lines]);
