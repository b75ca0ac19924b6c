import { mkdirSync, readdirSync, rmSync, statSync } from 'node:fs';
import { homedir } from 'node:os';
import { dirname, isAbsolute, join } from 'node:path';
import process from 'node:process';
import { replaceFile } from '../disk.ts';
import { readRegularFile } from '../regular-file.ts';

/** bytes */
const LONGEST = 16;

/** Folders that are remembered. */
const MOST = 1000;

/** Where a person's programs keep what they remember, a file for each folder that was edited. */
function fileOf(folder: string): string {
  const { XDG_STATE_HOME, LOCALAPPDATA } = process.env;
  const own = process.platform === 'win32' ? LOCALAPPDATA : XDG_STATE_HOME;
  const usual: Record<string, string> = { win32: 'AppData/Local', darwin: 'Library/Application Support' };
  const state = own !== undefined && isAbsolute(own) ? own : join(homedir(), usual[process.platform] ?? '.local/state');
  return join(state, 'gravity-quest-toolkit', 'edit-ports', folder);
}

/**
 * The port that a folder was edited on the last time; null where that is not known.
 * @param folder its id, as the list of its levels has it
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

/** Remembers it for the next time, where anything can be remembered. */
export function keepPort(folder: string, port: number): void {
  try {
    const file = fileOf(folder);
    mkdirSync(dirname(file), { recursive: true });
    replaceFile(file, Buffer.from(`${port}\n`), () => {});
    forgetOldest(dirname(file));
  } catch {
    // no home, or one that can't be written: the next run takes the usual port
  }
}

function forgetOldest(state: string): void {
  const names = readdirSync(state);
  if (names.length <= MOST) return;
  const aged = names.map((name) => ({ path: join(state, name), time: statSync(join(state, name)).mtimeMs }));
  for (const { path } of aged.sort((a, b) => a.time - b.time).slice(0, names.length - MOST)) rmSync(path, { force: true });
}
