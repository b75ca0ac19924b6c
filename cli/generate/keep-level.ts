import { join } from 'node:path';
import { formatLevel, MAX_FILE_SIZE } from '../../schema/index.ts';
import type { Generated } from '../../solver/index.ts';
import { createFile, tryFolder } from '../disk.ts';
import { Failure, systemReason } from '../failure.ts';
import { makeFolders } from '../make-folders.ts';
import { NotAFile, readRegularFile } from '../regular-file.ts';
import { schemaReference } from '../schema-reference.ts';
import { namedPath } from '../shown-path.ts';

/** What happened to a generated level; `in the way`: another file has its name, which is not overwritten. */
export type Kept = 'written' | 'unchanged' | 'in the way';

const slugOf = (name: string): string =>
  name
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-|-$/g, '');

/** The file name of a level, made from its name and seed, so that the same seed gives the same file. */
export const generatedPath = (directory: string, name: string, seed: number): string =>
  join(directory, `${slugOf(name)}-${seed}.level.json`);

/** The file name of a level of a pack: its number, from 1, with as many digits as the last one has, and its name. */
export const packPath = (directory: string, name: string, number: number, count: number): string =>
  join(directory, `${`${number}`.padStart(Math.max(2, `${count}`.length), '0')}-${slugOf(name)}.level.json`);

/**
 * Writes a level to a new file: completely or not at all.
 * @throws Failure if it can't be written
 */
export function keepLevel(directory: string, path: string, { level }: Generated): Kept {
  const $schema = schemaReference(directory) ?? undefined;
  const text = formatLevel({ $schema, ...level });
  try {
    if (createFile(path, Buffer.from(text))) return 'written';
    return Buffer.from(text).equals(readRegularFile(path, MAX_FILE_SIZE)) ? 'unchanged' : 'in the way';
  } catch (error) {
    if (error instanceof NotAFile) return 'in the way';
    throw new Failure(`${path}: can't be written: ${systemReason(error)}`);
  }
}

/** Creates the directory if it is missing, and tries to write into it. @throws Failure if that fails */
export function makeDirectory(directory: string): void {
  const fail = (what: string, error: unknown): never => {
    const reason = systemReason(error);
    throw new Failure(`--out ${namedPath(directory)}: ${what}: ${reason}; expected a directory that can be written`);
  };
  try {
    makeFolders(directory);
  } catch (error) {
    fail("the directory can't be created", error);
  }
  try {
    tryFolder(directory);
  } catch (error) {
    fail('no file can be created in it', error);
  }
}
