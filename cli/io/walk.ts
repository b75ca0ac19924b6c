import { type Dirent, readdirSync, readFileSync, realpathSync, type Stats, statSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { Failure, systemReason } from '../terminal/index.ts';

/** How a folder is walked. */
export interface Walking {
  /**
   * `followed`: a link counts as what it leads to, no folder is entered twice, and a broken link is a file, so that reading it
   * reports the error. `listed`: a link is a file that is known to be one, and is never followed.
   */
  readonly links: 'followed' | 'listed';
  /** What is done with hidden folders and node_modules. */
  readonly hidden: 'entered' | 'passed by';
  /** Whether a file counts, by its path below the folder. */
  readonly passes: (below: string) => boolean;
}

/** What is below a folder, by paths from there, with slashes, in no particular order. */
export interface Walked {
  readonly files: readonly { readonly below: string; readonly isLink: boolean }[];
  /** '' and every folder that was entered. */
  readonly folders: readonly string[];
  /** Folders that could not be read: system errors. */
  readonly unreadable: readonly { readonly below: string; readonly error: unknown }[];
}

/** Lists what is below a folder. Everything in gq that looks through folders comes here. */
export function walk(root: string, { links, hidden, passes }: Walking): Walked {
  const files: { below: string; isLink: boolean }[] = [];
  const folders: string[] = [];
  const unreadable: { below: string; error: unknown }[] = [];
  const seen = new Set<string>();
  const pending = [''];
  for (let folder = pending.pop(); folder !== undefined; folder = pending.pop()) {
    let entries: Dirent[];
    try {
      const path = folder === '' ? root : join(root, folder);
      if (links === 'followed') {
        const real = realpathSync(path);
        if (seen.has(real)) continue;
        seen.add(real);
      }
      entries = readdirSync(path, { withFileTypes: true });
    } catch (error) {
      unreadable.push({ below: folder, error });
      continue;
    }
    folders.push(folder);
    for (const entry of entries) {
      const below = folder === '' ? entry.name : `${folder}/${entry.name}`;
      const isLink = entry.isSymbolicLink();
      const kind = isLink && links === 'followed' ? statOrError(join(root, below)) : entry;
      if (!(kind instanceof Error) && kind.isDirectory()) {
        if (hidden === 'entered' || isShown(entry.name)) pending.push(below);
      } else if (passes(below) && (kind instanceof Error || kind.isFile() || isLinkOf(kind))) files.push({ below, isLink });
    }
  }
  return { files, folders, unreadable };
}

/** Whether an entry is a link that is not followed. */
const isLinkOf = (kind: Dirent | Stats): boolean => kind.isSymbolicLink();

/** Whether a folder is neither hidden nor one of packages. */
export const isShown = (folder: string): boolean => !folder.startsWith('.') && folder !== 'node_modules';

/**
 * The files that a command means by a directory, sorted by path: every one below it whose path passes, except in hidden
 * directories and node_modules. Follows links.
 * @param passes gets the path as the directory is named
 * @param unreadable gets the directories that can't be read
 */
export function filesBelow(
  root: string,
  passes: (path: string) => boolean,
  unreadable: { path: string; reason: string }[],
): string[] {
  const prefix = root === '.' ? '' : root.endsWith('/') ? root : `${root}/`;
  const walked = walk(root, { links: 'followed', hidden: 'passed by', passes: (below) => passes(prefix + below) });
  for (const { below, error } of walked.unreadable)
    unreadable.push({ path: below === '' ? root : prefix + below, reason: systemReason(error) });
  return walked.files.map(({ below }) => prefix + below).sort((a, b) => (a < b ? -1 : a > b ? 1 : 0));
}

/**
 * The files of a built page by their path in its folder, with slashes.
 * @param what the page in messages
 * @throws Failure if there is no built page
 */
export function readBuilt(folder: string, what: string): Map<string, Uint8Array<ArrayBuffer>> {
  const files = new Map<string, Uint8Array<ArrayBuffer>>();
  try {
    const walked = walk(folder, { links: 'listed', hidden: 'entered', passes: () => true });
    for (const { error } of walked.unreadable) throw error;
    for (const { below, isLink } of walked.files)
      if (!isLink) files.set(below, new Uint8Array(readFileSync(join(folder, below))));
  } catch (error) {
    throw new Failure(`${what} can't be read: ${folder}: ${systemReason(error)}; npm run build makes it again`);
  }
  if (!files.has('index.html'))
    throw new Failure(`${what} is missing: expected ${join(folder, 'index.html')}; npm run build makes it`);
  return files;
}

/** Each file once, however its path is written. */
export const once = (files: readonly string[]): string[] => onceBy(files, (file) => file);

/** {@link once} for what has the path of a file, or `-` for standard input. */
export function onceBy<T>(things: readonly T[], pathOf: (thing: T) => string): T[] {
  const seen = new Set<string>();
  return things.filter((thing) => {
    const path = pathOf(thing);
    const full = path === '-' ? path : resolve(path);
    if (seen.has(full)) return false;
    seen.add(full);
    return true;
  });
}

/** The stats of a path, or the error. */
export function statOrError(path: string): Stats | Error {
  try {
    return statSync(path);
  } catch (error) {
    return error as Error;
  }
}
