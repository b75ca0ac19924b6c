import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { type Command, InvalidArgumentError } from 'commander';
import { configFolders } from '../config/index.ts';

/** The values of the options that `addCacheOptions` declares. */
export interface CacheOptions {
  readonly cache?: boolean;
  readonly cacheDir?: string;
}

/** Declares `--cache`, `--no-cache` and `--cache-dir`. */
export function addCacheOptions(command: Command): Command {
  return command
    .option('--cache', 'use reports of earlier checks of the same content, where node_modules can keep them (default)')
    .option('--no-cache', 'check every level anew, and keep nothing')
    .option('--cache-dir <dir>', 'keep the cache here (default: node_modules/.cache/gq of the project)', parseFolder);
}

function parseFolder(text: string): string {
  if (text !== '') return text;
  throw new InvalidArgumentError('expected a folder, found an empty name');
}

/** What options choose, else what the configuration does. */
export const chosenCache = ({ cache, cacheDir }: CacheOptions, configured: CacheChoice): CacheChoice =>
  cache === false ? false : (cacheDir ?? (cache === true && configured === false ? true : configured));

/** What options or a configuration say about the cache: whether to use it, or the folder for it; null: nothing. */
type CacheChoice = boolean | string | null;

/**
 * The folder of the cache.
 * @param choice a folder, or false for no cache; else the cache is beside the packages of the project, where other tools keep theirs
 * @returns null for no cache, which includes a folder that belongs to no project with installed packages
 */
export function cacheFolder(choice: CacheChoice): string | null {
  if (choice === false) return null;
  if (typeof choice === 'string') return choice;
  const project = configFolders('').find((at) => existsSync(join(at, 'package.json')) && existsSync(join(at, 'node_modules')));
  return project === undefined ? null : join(project, 'node_modules', '.cache', 'gq');
}
