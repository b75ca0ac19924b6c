import { fileURLToPath } from 'node:url';
import { readBuilt } from '../io/index.ts';

/** The folder into which `npm run build` puts the game. */
export const GAME = fileURLToPath(new URL('../../site', import.meta.url));

/**
 * The files of the built game by their path in it, with slashes, sorted.
 * @throws Failure if there is no built game
 */
export const readGame = (folder: string): ReadonlyMap<string, Uint8Array> =>
  new Map([...readBuilt(folder, 'the game')].sort(([a], [b]) => (a < b ? -1 : 1)));
