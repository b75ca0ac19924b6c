import { type Command, InvalidArgumentError } from 'commander';
import type { CacheChoice } from './folder.ts';

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
