import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { formatLevel, MAX_FILE_SIZE } from '../../schema/index.ts';
import type { Generated } from '../../solver/index.ts';
import { createFile, tryFolder } from '../disk.ts';
import { Failure, systemReason } from '../failure.ts';
import { NotAFile, readRegularFile } from '../regular-file.ts';
import { schemaReference } from '../schema-reference.ts';
import { namedPath } from '../shown-path.ts';

/** What became of a level that was made: `in the way` is another file of that name, which stays. */
export type Kept = 'written' | 'unchanged' | 'in the way';

/** The file of a level: by its name and its seed, so that the same seed is the same file. */
export function generatedPath(directory: string, name: string, seed: number): string {
  const slug = name
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-|-$/g, '');
  return join(directory, `${slug}-${seed}.level.json`);
}

/**
 * Writes a level into a file that is not there yet, whole or not at all.
 * @throws Failure when it can't be written
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

/** Makes the directory where it is missing, and looks whether levels can be written into it. @throws Failure when they can't be */
export function makeDirectory(directory: string): void {
  const fail = (what: string, error: unknown): never => {
    const reason = systemReason(error);
    throw new Failure(`--out ${namedPath(directory)}: ${what}: ${reason}; expected a directory that can be written`);
  };
  try {
    mkdirSync(directory, { recursive: true });
  } catch (error) {
    fail("the directory can't be made", error);
  }
  try {
    tryFolder(directory);
  } catch (error) {
    fail('no file can be created in it', error);
  }
}
