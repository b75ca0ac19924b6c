import { readdirSync, readFileSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { Failure, systemReason } from '../failure.ts';

/** The folder into which `npm run build` puts the game. */
export const GAME = fileURLToPath(new URL('../../site', import.meta.url));

/**
 * The files of the built game by their path in it, with slashes, sorted.
 * @throws Failure if there is no built game
 */
export function readGame(folder: string): ReadonlyMap<string, Uint8Array> {
  const files = new Map<string, Uint8Array>();
  try {
    for (const entry of readdirSync(folder, { recursive: true, withFileTypes: true })) {
      if (!entry.isFile()) continue;
      const path = join(entry.parentPath, entry.name);
      files.set(relative(folder, path).split(sep).join('/'), readFileSync(path));
    }
  } catch (error) {
    throw new Failure(`the game can't be read: ${folder}: ${systemReason(error)}; npm run build makes it again`);
  }
  if (!files.has('index.html'))
    throw new Failure(`the game is missing: expected ${join(folder, 'index.html')}; npm run build makes it`);
  return new Map([...files].sort(([a], [b]) => (a < b ? -1 : 1)));
}
