import { createHash } from 'node:crypto';
import { accessSync, closeSync, constants, fstatSync, lstatSync, openSync, readFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { type LevelEntry, MAX_FILE_SIZE, type Problem, type ReadResponse, readLevel } from '../../schema/index.ts';
import { systemReason } from '../failure.ts';
import type { LevelFileFound } from './level-files.ts';

/** A strong entity tag of a content, quotes and all. */
export const etagOf = (bytes: Uint8Array): string => `"${createHash('sha256').update(bytes).digest('hex')}"`;

/** What a content is, whichever file has it. */
interface Judgement {
  readonly status: 'valid' | 'invalid';
  readonly name: string | null;
  readonly problems: readonly Problem[];
  readonly text: string;
}

function judge(bytes: Uint8Array): Judgement {
  const read = readLevel(bytes);
  return read.ok
    ? { status: 'valid', name: read.level.name, problems: [], text: read.document.text }
    : { status: 'invalid', name: null, problems: read.problems, text: read.text };
}

/** Reads files and judges them; a content that it has seen is known by its hash. */
export interface EntryReader {
  /** Never throws: what can't be read says why. */
  read(found: LevelFileFound): ReadResponse;
  /** Forgets contents that no file has any more. */
  keepOnly(etags: ReadonlySet<string | null>): void;
}

/** @param nameOf the path of a file as people know it, from its id */
export function createEntryReader(nameOf: (id: string) => string): EntryReader {
  const judged = new Map<string, Judgement>();

  const read = (found: LevelFileFound): ReadResponse => {
    const { id } = found;
    const file = nameOf(id);
    if (found.isLink) {
      const why = "it is a symbolic link, which the editor doesn't follow";
      return unreadable(id, file, why, 'Open the folder of the file it leads to.');
    }
    let bytes: Uint8Array | null;
    try {
      bytes = readRegularFile(found.path);
    } catch (error) {
      return unreadable(id, file, `it can't be read: ${systemReason(error)}`, 'Make the file readable.');
    }
    if (bytes === null)
      return unreadable(id, file, 'it is larger than 8 MiB', 'Is it a level? Rename it if not.', 'file-too-large');
    const etag = etagOf(bytes);
    let judgement = judged.get(etag);
    if (judgement === undefined) {
      judgement = judge(bytes);
      judged.set(etag, judgement);
    }
    const { status, name, problems, text } = judgement;
    return { id, file, etag, status, name, problems: [...problems], readOnly: whyReadOnly(found.path), text };
  };

  const keepOnly = (etags: ReadonlySet<string | null>): void => {
    for (const etag of judged.keys()) if (!etags.has(etag)) judged.delete(etag);
  };
  return { read, keepOnly };
}

/** The entry without the text. */
export function entryOf({ text: _, ...entry }: ReadResponse): LevelEntry {
  return entry;
}

function unreadable(id: string, file: string, why: string, hint: string, code = 'unreadable-file'): ReadResponse {
  const problem: Problem = { code, severity: 'error', message: why, hint, pointer: '', line: null, column: null };
  return { id, file, etag: null, status: 'unreadable', name: null, problems: [problem], readOnly: why, text: null };
}

// a link that took the file's place since it was listed is not followed, a pipe not waited for; Windows knows neither
const READ = constants.O_RDONLY | (constants.O_NOFOLLOW ?? 0) | (constants.O_NONBLOCK ?? 0);

/**
 * The bytes of a regular file; null when it is larger than a level may be.
 * @throws what the operating system says, also when it is not a regular file
 */
export function readRegularFile(path: string): Uint8Array | null {
  if (!lstatSync(path).isFile()) throw new Error('it is not a regular file');
  const descriptor = openSync(path, READ);
  try {
    const stats = fstatSync(descriptor);
    if (!stats.isFile()) throw new Error('it is not a regular file');
    if (stats.size > MAX_FILE_SIZE) return null;
    return readFileSync(descriptor);
  } finally {
    closeSync(descriptor);
  }
}

function whyReadOnly(path: string): string | null {
  for (const [what, checked] of [
    ['the file', path],
    ['its folder', dirname(path)],
  ]) {
    try {
      accessSync(checked, constants.W_OK);
    } catch (error) {
      return `${what} can't be written: ${systemReason(error)}`;
    }
  }
  return null;
}
