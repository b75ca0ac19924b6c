import { readdirSync, rmSync, statSync } from 'node:fs';
import { homedir } from 'node:os';
import { dirname, isAbsolute, join } from 'node:path';
import process from 'node:process';
import { replaceFile } from '../disk.ts';
import { makeFolders } from '../make-folders.ts';
import { readRegularFile } from '../regular-file.ts';

/** bytes; a port number is shorter */
const LONGEST = 16;

/** The largest number of folders that are remembered. */
const MOST = 1000;

/** The user's directory for program state; it contains a file for each edited folder. */
function fileOf(folder: string): string {
  const { XDG_STATE_HOME, LOCALAPPDATA } = process.env;
  const own = process.platform === 'win32' ? LOCALAPPDATA : XDG_STATE_HOME;
  const usual: Record<string, string> = { win32: 'AppData/Local', darwin: 'Library/Application Support' };
  const state = own !== undefined && isAbsolute(own) ? own : join(homedir(), usual[process.platform] ?? '.local/state');
  return join(state, 'gravity-quest-toolkit', 'edit-ports', folder);
}

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

function forgetOldest(state: string): void {
  const names = readdirSync(state);
  if (names.length <= MOST) return;
  const aged = names.map((name) => ({ path: join(state, name), time: statSync(join(state, name)).mtimeMs }));
  for (const { path } of aged.sort((a, b) => a.time - b.time).slice(0, names.length - MOST)) rmSync(path, { force: true });
}
