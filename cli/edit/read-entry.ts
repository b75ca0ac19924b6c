import { createHash } from 'node:crypto';
import { accessSync, constants, lstatSync, statSync } from 'node:fs';
import { dirname } from 'node:path';
import { type LevelEntry, MAX_FILE_SIZE, type Problem, type ReadResponse, readLevel } from '../../schema/index.ts';
import { systemReason } from '../failure.ts';
import { readRegularFile } from '../regular-file.ts';
import { whyNotWritable } from '../writable.ts';
import type { LevelFileFound } from './level-files.ts';

/** A strong entity tag of a content, quotes and all. */
export const etagOf = (bytes: Uint8Array): string => `"${createHash('sha256').update(bytes).digest('hex')}"`;

/** What a content is, whichever file has it. Without its text: there may be very many. */
interface Judgement {
  readonly status: 'valid' | 'invalid';
  readonly name: string | null;
  readonly problems: readonly Problem[];
}

function judge(bytes: Uint8Array): Judgement & { readonly text: string } {
  const read = readLevel(bytes);
  return read.ok
    ? { status: 'valid', name: read.level.name, problems: [], text: read.document.text }
    : { status: 'invalid', name: null, problems: read.problems, text: read.text };
}

/** Reads files and judges them; a content that it has seen is known by its hash. */
export interface EntryReader {
  /** Reads the file. Never throws: what can't be read says why. */
  read(found: LevelFileFound): ReadResponse;
  /**
   * What a list says of the file: what it said the last time, the same object, where the system says that nothing has touched the file
   * since. For lists alone: what is changed is always read.
   */
  entry(found: LevelFileFound): LevelEntry;
  /** Forgets what is in no list any more. */
  keepOnly(entries: readonly LevelEntry[]): void;
}

/** ms; a file that was touched so shortly before it was read may be touched again without a later time being noted */
const COARSEST_CLOCK = 2000;

/** @param nameOf the path of a file as people know it, from its id */
export function createEntryReader(nameOf: (id: string) => string): EntryReader {
  const judged = new Map<string, Judgement>();
  const listed = new Map<string, { readonly mark: string; readonly entry: LevelEntry }>();

  /** @param judgementOf of a content with this etag */
  const look = <J extends Judgement>(
    { id, path, isLink }: LevelFileFound,
    judgementOf: (etag: string, bytes: Uint8Array) => J,
  ): { readonly entry: LevelEntry; readonly judgement: J | null } => {
    const file = nameOf(id);
    const refuse = (why: string, hint: string, code?: string) => ({
      entry: unreadable(id, file, why, hint, code),
      judgement: null,
    });
    if (isLink) {
      return refuse("it is a symbolic link, which the editor doesn't follow", 'Open the folder of the file that it points to.');
    }
    let bytes: Uint8Array;
    try {
      bytes = readRegularFile(path, MAX_FILE_SIZE, NO_FOLLOW);
    } catch (error) {
      return refuse(`it can't be read: ${systemReason(error)}`, 'Make the file readable.');
    }
    if (bytes.length > MAX_FILE_SIZE)
      return refuse('it is larger than 8 MiB', 'Check that it is a level; rename it if it is not.', 'file-too-large');
    const etag = etagOf(bytes);
    const judgement = judgementOf(etag, bytes);
    const { status, name, problems } = judgement;
    return { entry: { id, file, etag, status, name, problems: [...problems], readOnly: whyReadOnly(path) }, judgement };
  };

  const read = (found: LevelFileFound): ReadResponse => {
    const { entry, judgement } = look(found, (_, bytes) => judge(bytes));
    return { ...entry, text: judgement?.text ?? null };
  };

  const entry = (found: LevelFileFound): LevelEntry => {
    const mark = markOf(found);
    const last = listed.get(found.id);
    if (mark !== null && last?.mark === mark) return last.entry;
    const { entry: fresh } = look(found, (etag, bytes) => {
      let judgement = judged.get(etag);
      if (judgement === undefined) {
        const { text: _, ...rest } = judge(bytes);
        judgement = rest;
        judged.set(etag, judgement);
      }
      return judgement;
    });
    if (mark === null) listed.delete(found.id);
    else listed.set(found.id, { mark, entry: fresh });
    return fresh;
  };

  const keepOnly = (entries: readonly LevelEntry[]): void => {
    const ids = new Set(entries.map(({ id }) => id));
    for (const id of listed.keys()) if (!ids.has(id)) listed.delete(id);
    const etags = new Set(entries.map(({ etag }) => etag));
    for (const etag of judged.keys()) if (!etags.has(etag)) judged.delete(etag);
  };
  return { read, entry, keepOnly };
}

/** What the system notes of a file when anybody touches it; null where it may be touched again unnoticed. */
function markOf({ path, isLink }: LevelFileFound): string | null {
  try {
    const file = lstatSync(path, { bigint: true });
    const folder = statSync(dirname(path), { bigint: true });
    const latest = Math.max(Number(file.mtimeMs), Number(file.ctimeMs));
    if (isLink || Math.abs(Date.now() - latest) < COARSEST_CLOCK) return null;
    return [file.dev, file.ino, file.size, file.mode, file.uid, file.mtimeNs, file.ctimeNs, folder.mode, folder.uid].join();
  } catch {
    return null;
  }
}

/** The entry without the text. */
export function entryOf({ text: _, ...entry }: ReadResponse): LevelEntry {
  return entry;
}

function unreadable(id: string, file: string, why: string, hint: string, code = 'unreadable-file'): LevelEntry {
  const problem: Problem = { code, severity: 'error', message: why, hint, pointer: '', line: null, column: null };
  return { id, file, etag: null, status: 'unreadable', name: null, problems: [problem], readOnly: why };
}

// a link that took the file's place since it was listed is not followed; Windows knows no such flag
const NO_FOLLOW = constants.O_NOFOLLOW ?? 0;

function whyReadOnly(path: string): string | null {
  const why = whyNotWritable(path);
  if (why !== null) return `the file can't be written: ${why}`;
  try {
    accessSync(dirname(path), constants.W_OK);
    return null;
  } catch (error) {
    return `its folder can't be written: ${systemReason(error)}`;
  }
}
