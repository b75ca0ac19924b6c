import { readdirSync, rmSync, statSync } from 'node:fs';
import { homedir } from 'node:os';
import { isAbsolute, join } from 'node:path';
import process from 'node:process';

/** The largest number of files of one kind. */
const MOST = 1000;

/** The folder of one kind of files in the user's directory for program state. */
export function stateFolder(kind: string): string {
  const { XDG_STATE_HOME, LOCALAPPDATA } = process.env;
  const own = process.platform === 'win32' ? LOCALAPPDATA : XDG_STATE_HOME;
  const usual: Record<string, string> = { win32: 'AppData/Local', darwin: 'Library/Application Support' };
  const state = own !== undefined && isAbsolute(own) ? own : join(homedir(), usual[process.platform] ?? '.local/state');
  return join(state, 'gravity-quest-toolkit', kind);
}

/** Removes the oldest files where there are very many. */
export function forgetOldest(folder: string): void {
  const names = readdirSync(folder);
  if (names.length <= MOST) return;
  const aged = names.map((name) => ({ path: join(folder, name), time: statSync(join(folder, name)).mtimeMs }));
  for (const { path } of aged.sort((a, b) => a.time - b.time).slice(0, names.length - MOST)) rmSync(path, { force: true });
}
