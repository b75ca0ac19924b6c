import { existsSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import process from 'node:process';

export const CONFIG_NAME = 'gq.config.json';

/** Folders in which the configuration of a folder is looked for, the nearest first. */
export function configFolders(folder: string): string[] {
  const folders: string[] = [];
  for (let at = resolve(folder); ; at = dirname(at)) {
    folders.push(at);
    if (existsSync(join(at, '.git')) || dirname(at) === at) return folders;
  }
}

/**
 * The configuration that holds in a folder: the nearest `gq.config.json` from there upwards to the root of the repository, the first
 * folder with a `.git`; where there is none, to the root of the file system.
 * @returns its path as it is shorter to read; null where there is none
 */
export function findConfig(folder: string = process.cwd()): string | null {
  const path = configFolders(folder)
    .map((at) => join(at, CONFIG_NAME))
    .find((one) => existsSync(one));
  return path === undefined ? null : relative('', path);
}
