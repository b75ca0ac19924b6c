import { basename, join, resolve } from 'node:path';
import { formatLevel, formatPack, MAX_FILE_SIZE, PACK_NAME, PACK_VERSION } from '../../schema/index.ts';
import type { Generated } from '../../solver/index.ts';
import {
  createFile,
  Failure,
  levelIdOf,
  makeFolders,
  NotAFile,
  namedPath,
  readRegularFile,
  systemReason,
  tryFolder,
} from '../io/index.ts';
import { schemaReference } from '../schema-reference.ts';

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
  return keep(path, formatLevel({ $schema, ...level }));
}

function keep(path: string, text: string): Kept {
  try {
    if (createFile(path, Buffer.from(text))) return 'written';
    return Buffer.from(text).equals(readRegularFile(path, MAX_FILE_SIZE)) ? 'unchanged' : 'in the way';
  } catch (error) {
    if (error instanceof NotAFile) return 'in the way';
    throw new Failure(`${path}: can't be written: ${systemReason(error)}`);
  }
}

/** The pack file of generated levels, and what happened to it. */
export interface KeptPack {
  readonly file: string;
  readonly status: Kept;
}

/**
 * Writes the order of a pack to a new file: completely or not at all.
 * @param levels the paths of its level files, in order
 * @throws Failure if it can't be written
 */
export function keepPack(directory: string, levels: readonly string[]): KeptPack {
  const file = join(directory, PACK_NAME);
  const $schema = schemaReference(directory, 'pack') ?? undefined;
  const name = basename(resolve(directory)) || 'Generated levels';
  const ids = levels.map((level) => levelIdOf(directory, level));
  return {
    file,
    status: keep(file, formatPack({ ...($schema !== undefined && { $schema }), version: PACK_VERSION, name, levels: ids })),
  };
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
