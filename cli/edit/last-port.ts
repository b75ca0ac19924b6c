import { dirname, join } from 'node:path';
import { makeFolders, readRegularFile, replaceFile } from '../io/index.ts';
import { forgetOldest, stateFolder } from './user-state.ts';

/** bytes; a port number is shorter */
const LONGEST = 16;

/** The user's directory for program state contains a file for each edited folder. */
const fileOf = (folder: string): string => join(stateFolder('edit-ports'), folder);

/**
 * The port on which a folder was last edited; null if it is not known.
 * @param folder its id, as in the list of its levels
 */
export function lastPort(folder: string): number | null {
  try {
    const text = Buffer.from(readRegularFile(fileOf(folder), LONGEST)).toString();
    const port = Number(text);
    return /^\d{1,5}\n$/.test(text) && port > 0 && port < 65536 ? port : null;
  } catch {
    return null;
  }
}

/** Remembers the port for the next run, if it can be stored. */
export function keepPort(folder: string, port: number): void {
  try {
    const file = fileOf(folder);
    makeFolders(dirname(file));
    replaceFile(file, Buffer.from(`${port}\n`), () => {});
    forgetOldest(dirname(file));
  } catch {
    // no home directory, or not writable: the next run uses the usual port
  }
}
