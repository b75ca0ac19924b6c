import { appendFileSync, closeSync, existsSync, lstatSync, openSync, rmdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import type { ResultFile } from '../command.ts';
import { allOrNone, Failure, hearSignals, namedPath, shellPath, systemReason, uncut, withUndo } from '../terminal/index.ts';
import { LineWriter, makeFolders, renamePatiently, replaceFile } from './disk.ts';
import { readRegularFile } from './regular-file.ts';
import { realTarget, whyNotWritable } from './replaceable.ts';

/** Whether something is there that is no file. A pipe behind /dev/stdout has no path of its own, so links are not followed by name. */
function isDevice(path: string): boolean {
  const stats = tryTo(path, () => statSync(path, { throwIfNoEntry: false }));
  return stats !== undefined && !stats.isFile();
}

/**
 * Writes a file completely or not at all, and keeps the mode of an existing file. A device or pipe is written directly.
 * @throws Failure with the reason if it can't be written
 */
export async function writeWhole(path: string, content: string | Uint8Array): Promise<void> {
  const bytes = typeof content === 'string' ? Buffer.from(content) : content;
  // writing may wait for a reader, and a signal must be able to end that
  if (isDevice(path)) return tryTo(path, () => writeFileSync(path, bytes));
  const target = tryTo(path, () => realTarget(path));
  await uncut(() => tryTo(path, () => replace(target, bytes)));
}

/**
 * Writes a file piece by piece, completely or not at all: for one that is too large for memory.
 * @throws Failure with the reason if it can't be written
 */
export async function writePieces(path: string, pieces: Iterable<string>): Promise<void> {
  if (isDevice(path)) {
    const descriptor = tryTo(path, () => openSync(path, 'w'));
    try {
      for (const piece of pieces) tryTo(path, () => writeFileSync(descriptor, piece));
    } finally {
      closeSync(descriptor);
    }
    return;
  }
  const target = tryTo(path, () => realTarget(path));
  const why = existsSync(target) ? whyNotWritable(target) : null;
  if (why !== null) throw new Failure(`${path}: can't be written: ${why}`);
  const out = tryTo(path, () => new LineWriter(target));
  const discard = (): void => out.discard();
  try {
    await withUndo(discard, async () => {
      let heard = performance.now();
      for (const piece of pieces) {
        tryTo(path, () => out.write(piece));
        if (performance.now() - heard < SLICE) continue;
        await hearSignals();
        heard = performance.now();
      }
      tryTo(path, () => out.end());
      tryTo(path, () => renamePatiently(out.unfinished, target));
    });
  } finally {
    discard();
  }
}

/** ms between two looks at signals */
const SLICE = 20;

/** The same within work that no signal may interrupt; only for a regular file, or a path without a file. */
export function replaceRegular(path: string, content: Uint8Array): void {
  tryTo(path, () => {
    const target = realTarget(path);
    if (statSync(target, { throwIfNoEntry: false })?.isFile() === false) throw new Error('it is not a regular file');
    replace(target, content);
  });
}

function replace(target: string, bytes: Uint8Array): void {
  const why = lstatSync(target, { throwIfNoEntry: false }) === undefined ? null : whyNotWritable(target);
  if (why !== null) throw new Error(why);
  replaceFile(target, bytes, () => {});
}

/** What to do when the folder of a new file is missing. */
function missingFolder(path: string, error: unknown): string {
  const folder = dirname(path);
  const isMissing = (error as NodeJS.ErrnoException).code === 'ENOENT' && !existsSync(folder);
  return isMissing ? `; make the folder ${shellPath(folder)} first` : '';
}

function tryTo<T>(path: string, work: () => T): T {
  try {
    return work();
  } catch (error) {
    throw new Failure(`${path}: can't be written: ${systemReason(error)}${missingFolder(path, error)}`);
  }
}

/** What becomes of a file. */
export type FileStatus = 'written' | 'overwritten' | 'unchanged';

/** A file that a command is about to write. */
export interface PlannedFile {
  readonly file: string;
  readonly content: Uint8Array;
  /** The current content of the file; null if there is none. */
  readonly before: Uint8Array | null;
  readonly status: FileStatus;
}

/** The files that exist with another content than they would get. */
export const differing = <F extends PlannedFile>(files: readonly F[]): F[] =>
  files.filter(({ status }) => status === 'overwritten');

/**
 * Compares a file with what is to be written.
 * @param who the command, for the message if the existing file can't be read
 * @param limit the largest file that may be there, bytes
 */
export function planFile(file: string, content: string | Uint8Array, who: string, limit: number): PlannedFile {
  const bytes = typeof content === 'string' ? Buffer.from(content) : content;
  const before = contentOf(file, who, limit);
  const status = before === null ? 'written' : Buffer.from(bytes).equals(before) ? 'unchanged' : 'overwritten';
  return { file, content: bytes, before, status };
}

function contentOf(path: string, who: string, limit: number): Uint8Array | null {
  try {
    const bytes = readRegularFile(path, limit);
    if (bytes.length > limit) throw new Error('it is larger than such a file may be: move it away');
    return bytes;
  } catch (error) {
    if (['ENOENT', 'ENOTDIR'].includes((error as NodeJS.ErrnoException).code ?? '')) return null;
    throw new Failure(`${path}: ${who} writes a file here, but the existing one can't be read: ${systemReason(error)}`);
  }
}

/**
 * Writes all files or none, even if a signal interrupts it. Folders that are missing are made.
 * @param named how the command names a folder in a message; as its path when left out
 */
export async function writeAll(files: readonly PlannedFile[], named: (folder: string) => string = namedPath): Promise<void> {
  const changed = files.filter(({ status }) => status !== 'unchanged');
  const done: PlannedFile[] = [];
  const made: { readonly folder: string; readonly outermost: string }[] = [];
  const folders = [...new Set(changed.map(({ file }) => dirname(file)))];
  await allOrNone(
    [
      ...folders.map((folder) => () => {
        const outermost = makeFolder(folder, named);
        if (outermost !== undefined) made.push({ folder, outermost });
      }),
      ...changed.map((file) => () => {
        replaceRegular(file.file, file.content);
        done.push(file);
      }),
    ],
    () => {
      for (const { file, before } of done.reverse()) {
        if (before === null) rmSync(file, { force: true });
        else replaceRegular(file, before);
      }
      for (const { folder, outermost } of made.reverse()) removeFolders(folder, outermost);
    },
  );
}

/** @returns the outermost folder that was made, if any */
function makeFolder(folder: string, named: (folder: string) => string): string | undefined {
  try {
    return makeFolders(folder);
  } catch (error) {
    const reason = systemReason(error);
    throw new Failure(`${named(folder)}: the directory can't be created: ${reason}; expected a directory that can be written`);
  }
}

/** Removes empty folders, the innermost first. */
export function removeFolders(innermost: string, outermost: string): void {
  const last = resolve(outermost);
  for (let at = resolve(innermost); at.length >= last.length; at = dirname(at)) rmdirSync(at);
}

/**
 * Writes the files of a result. One that can't be written does not keep the others from being written.
 * @returns why a file could not be written, for each such file, and whether the command has failed because of it
 */
export async function writeResultFiles(files: readonly ResultFile[]): Promise<{ messages: string[]; failed: boolean }> {
  const messages: string[] = [];
  let failed = false;
  for (const file of files) {
    try {
      await write(file);
    } catch (error) {
      if (!(error instanceof Failure)) throw error;
      const isReport = file.mode === 'replace';
      if (isReport) failed = true;
      messages.push(`${isReport ? 'error' : 'warning'}: ${error.message}`);
    }
  }
  return { messages, failed };
}

async function write({ path, content, mode }: ResultFile): Promise<void> {
  if (mode === 'replace') {
    makeFolderOf(path);
    return typeof content === 'string' || content instanceof Uint8Array ? writeWhole(path, content) : writePieces(path, content);
  }
  await uncut(() => {
    try {
      for (const piece of typeof content === 'string' || content instanceof Uint8Array ? [content] : content)
        appendFileSync(path, piece);
    } catch (error) {
      throw new Failure(`${path}: can't be written: ${systemReason(error)}`);
    }
  });
}

function makeFolderOf(path: string): void {
  try {
    makeFolders(dirname(path));
  } catch (error) {
    throw new Failure(`${path}: its folder can't be made: ${systemReason(error)}`);
  }
}
