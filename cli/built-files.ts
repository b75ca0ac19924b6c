import { readdirSync, readFileSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { Failure, systemReason } from './failure.ts';

/**
 * The files of a built page by their path in its folder, with slashes.
 * @param what the page in messages
 * @throws Failure if there is no built page
 */
export function readBuilt(folder: string, what: string): Map<string, Uint8Array<ArrayBuffer>> {
  const files = new Map<string, Uint8Array<ArrayBuffer>>();
  try {
    for (const entry of readdirSync(folder, { recursive: true, withFileTypes: true })) {
      if (!entry.isFile()) continue;
      const path = join(entry.parentPath, entry.name);
      files.set(relative(folder, path).split(sep).join('/'), new Uint8Array(readFileSync(path)));
    }
  } catch (error) {
    throw new Failure(`${what} can't be read: ${folder}: ${systemReason(error)}; npm run build makes it again`);
  }
  if (!files.has('index.html'))
    throw new Failure(`${what} is missing: expected ${join(folder, 'index.html')}; npm run build makes it`);
  return files;
}
