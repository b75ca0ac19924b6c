import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { configFolders } from '../config-file.ts';

/** What options or a configuration say about the cache: whether to use it, or the folder for it; null: nothing. */
export type CacheChoice = boolean | string | null;

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
