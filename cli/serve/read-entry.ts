import { createHash } from 'node:crypto';
import { accessSync, constants, lstatSync, statSync } from 'node:fs';
import { dirname } from 'node:path';
import { type LevelEntry, MAX_FILE_SIZE, type Problem, type ReadResponse, readLevel } from '../../schema/index.ts';
import { readRegularFile, whyNotWritable } from '../io/index.ts';
import { systemReason } from '../terminal/index.ts';
import type { LevelFileFound } from './level-files.ts';

/** The strong entity tag of a content, including the quotes. */
export const etagOf = (bytes: Uint8Array): string => `"${createHash('sha256').update(bytes).digest('hex')}"`;

/** What a content is, independent of the file. Without the text, as there may be very many. */
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

/** Reads and validates level files. It remembers contents by their hash, so that each is validated only once. */
export interface EntryReader {
  /** Reads the file. Never throws: the result says why a file can't be read. */
  read(found: LevelFileFound): ReadResponse;
  /**
   * The list entry of the file: the same object as the last time if, according to the system, the file is untouched since. For
   * lists only: before a change, the file is always read.
   */
  entry(found: LevelFileFound): LevelEntry;
  /** Forgets everything that is not in these entries. */
  keepOnly(entries: readonly LevelEntry[]): void;
}

/** ms; a file modified so recently may be modified again without a new timestamp */
const COARSEST_CLOCK = 2000;

/** @param nameOf the path of a level as the user sees it */
export function createEntryReader(nameOf: (id: string) => string): EntryReader {
  const judged = new Map<string, Judgement>();
  const listed = new Map<string, { readonly mark: string; readonly entry: LevelEntry }>();

  /** @param judgementOf judges a content with this etag */
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

/** File attributes that change whenever the file is modified; null if a modification could go unnoticed. */
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

// if a link has replaced the file since it was listed, it is not followed; Windows has no such flag
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

/** What a change is based on: the etag of the content that the client knows, or that there is no such file. */
export type Base = { readonly etag: string } | 'no-file';
