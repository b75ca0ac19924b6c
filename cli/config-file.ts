import { existsSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import process from 'node:process';

const NAME = 'gq.config.json';

/**
 * The configuration that holds in a folder: the nearest `gq.config.json` from there upwards to the root of the repository, the first
 * folder with a `.git`; where there is none, to the root of the file system.
 * @returns its path as it is shorter to read; null where there is none
 */
export function findConfig(folder: string = process.cwd()): string | null {
  for (let at = resolve(folder); ; at = dirname(at)) {
    const path = join(at, NAME);
    if (existsSync(path)) return relative('', path);
    if (existsSync(join(at, '.git')) || dirname(at) === at) return null;
  }
}
