import { spawn } from 'node:child_process';
import { realpathSync } from 'node:fs';
import { basename, dirname, join, relative, sep } from 'node:path';
import process from 'node:process';
import type { EditorPlace } from '../../schema/index.ts';
import { siblingHint, statOrError } from '../io/index.ts';
import { Failure, namedPath, shellPath, systemReason } from '../terminal/index.ts';
import { findLevel, SUFFIX } from './level-files.ts';

/** The folder to edit, and the place to open in it; null: the page decides. */
interface OpenedPlace {
  readonly folder: string;
  readonly place: EditorPlace | null;
}

const USUAL_FOLDER = 'levels';

const EXPECTED = 'expected FILE or FILE:TICK, like levels/07-slingshot.level.json:412';

/**
 * What `gq edit DIR --open FILE:TICK --run NAME` asks for.
 * @param folder DIR; undefined if none is given
 * @param wanted the value of `--open`; undefined if there is none
 * @throws Failure if there is no such file, or the folder does not contain it
 */
export function openedPlace(folder: string | undefined, wanted: string | undefined, run: string | undefined): OpenedPlace {
  if (wanted === undefined) {
    if (run !== undefined) throw new Failure('--run names the run that --open shows: give --open FILE as well');
    return { folder: folder ?? USUAL_FOLDER, place: null };
  }
  const { file, tick } = fileAndTick(wanted, folder);
  if (isFolder(file)) {
    // gq edit --open levels: the folder comes after the option
    if (tick === null && folder === undefined && run === undefined) return { folder: file, place: null };
    throw new Failure(`--open ${namedPath(wanted)}: is a folder; ${EXPECTED}`);
  }
  if (!basename(file).endsWith(SUFFIX)) {
    throw new Failure(`--open ${file}: the editor opens only files whose names end in ${SUFFIX}; rename it`);
  }
  const chosen = folder ?? (idIn(USUAL_FOLDER, file) === null ? dirname(file) : USUAL_FOLDER);
  const id = idIn(chosen, file);
  if (id === null) {
    const where = shellPath(dirname(file));
    throw new Failure(
      `--open ${file}: the folder ${namedPath(chosen)} does not show this file: expected a file in it or below, not in a hidden folder or node_modules; try gq edit ${where} --open ${shellPath(wanted)}`,
    );
  }
  return { folder: chosen, place: { level: id + SUFFIX, run: run ?? null, tick } };
}

const isFolder = (path: string): boolean => {
  const stats = statOrError(path);
  return !(stats instanceof Error) && stats.isDirectory();
};

/** Splits `FILE:TICK`. A file may itself have a colon in its name, as in `C:\07.level.json`: what exists is a file. */
function fileAndTick(wanted: string, folder: string | undefined): { file: string; tick: number | null } {
  const found = existing(wanted, folder);
  if (found !== null) return { file: found, tick: null };
  const [, path, digits] = /^(.+):(\d{1,9})$/s.exec(wanted) ?? [];
  const before = path === undefined ? null : existing(path, folder);
  if (before !== null) return { file: before, tick: Number(digits) };
  const colon = wanted.lastIndexOf(':');
  if (colon > 0 && existing(wanted.slice(0, colon), folder) !== null) {
    throw new Failure(
      `--open ${wanted}: expected a tick after the colon, a whole number like 412; found ${JSON.stringify(wanted.slice(colon + 1))}`,
    );
  }
  const named = path ?? wanted;
  const error = statOrError(named);
  const reason = error instanceof Error ? systemReason(error) : 'it is not a file';
  throw new Failure(`--open ${namedPath(wanted)}: ${reason}${siblingHint(named)}; ${EXPECTED}`);
}

/** The path of an existing file or folder, as given or else inside the edited folder; null if there is none. */
function existing(path: string, folder: string | undefined): string | null {
  if (path === '') return null;
  const paths = folder === undefined ? [path] : [path, join(folder, path)];
  return paths.find((one) => !(statOrError(one) instanceof Error)) ?? null;
}

/** The id of a file in a folder as the editor lists it; null if it does not list the file. */
function idIn(folder: string, file: string): string | null {
  try {
    const root = realpathSync(folder);
    // the file itself may be a link: it is listed where it is
    const path = join(realpathSync(dirname(file)), basename(file));
    const id = relative(root, path).split(sep).join('/').slice(0, -SUFFIX.length);
    return findLevel(root, id)?.id ?? null;
  } catch {
    return null;
  }
}

/** The command that opens an address in the user's default browser; no shell interprets it. */
function opener(address: string): [command: string, args: string[]] {
  if (process.platform === 'darwin') return ['open', [address]];
  if (process.platform === 'win32') return ['rundll32', ['url.dll,FileProtocolHandler', address]];
  return ['xdg-open', [address]];
}

/**
 * Opens an address in the browser.
 * @param onFailure called with the reason if it can't be opened
 */
export function openBrowser(address: string, onFailure: (why: string) => void): void {
  const [command, args] = opener(address);
  const child = spawn(command, args, { stdio: 'ignore', detached: true });
  child.on('error', (error) => onFailure(`${command}: ${systemReason(error)}`));
  child.on('exit', (code) => {
    if (code !== null && code !== 0) onFailure(`${command} ended with ${code}`);
  });
  child.unref();
}
