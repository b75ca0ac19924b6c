import { rmdirSync, rmSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { Failure, systemReason } from './failure.ts';
import { makeFolders } from './make-folders.ts';
import { readRegularFile } from './regular-file.ts';
import { namedPath } from './shown-path.ts';
import { allOrNone } from './signals.ts';
import { replaceRegular } from './write-file.ts';

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
