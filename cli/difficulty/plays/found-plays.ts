import { resolve } from 'node:path';
import process from 'node:process';
import { Failure, filesBelow, namedPath, STDIN, siblingHint, sortedByPlay, statOrError, systemReason } from '../../io/index.ts';

/** A file with plays. */
export interface PlayFile {
  readonly path: string;
  /** Whether each of its lines is a play; else the file is one play. */
  readonly hasLines: boolean;
  /** Who played: the folder below the one that was given; null if the file is not in such a folder. */
  readonly player: string | null;
}

/** The files with plays that paths name. */
export interface FoundPlays {
  /** In the order of the paths; the files of a directory in natural order, `2.gqr` before `10.gqr`. */
  readonly files: readonly PlayFile[];
  /** How many other files are in the directories. */
  readonly ignored: number;
  /** Directories that could not be read. */
  readonly unreadable: readonly { readonly path: string; readonly reason: string }[];
}

const PLAY = /\.gqr$/i;
const LINES = /\.(?:ndjson|jsonl)$/i;

/**
 * Finds plays. A directory stands for every play below it, except in hidden directories and node_modules. A file that is named
 * counts whatever its name: as a play if it ends in `.gqr`, else as lines.
 * @throws Failure with every path that has no play
 */
export function findPlays(paths: readonly string[]): FoundPlays {
  const files: PlayFile[] = [];
  const unreadable: { path: string; reason: string }[] = [];
  const unmatched: string[] = [];
  let ignored = 0;
  for (const path of paths) {
    if (path === STDIN && process.stdin.isTTY) {
      throw new Failure('standard input is a terminal: expected plays from a file or a pipe, as in --plays - < plays.ndjson');
    }
    const stats = path === STDIN ? null : statOrError(path);
    if (stats instanceof Error) {
      const hint = (stats as NodeJS.ErrnoException).code === 'ENOENT' ? siblingHint(path) : '';
      unmatched.push(`${namedPath(path)}: ${systemReason(stats)}${hint}`);
    } else if (stats === null || !stats.isDirectory()) {
      files.push({ path, hasLines: !PLAY.test(path), player: null });
    } else {
      const before = unreadable.length;
      const all = filesBelow(path, () => true, unreadable);
      const plays = all.filter((file) => PLAY.test(file) || LINES.test(file));
      const others = all.length - plays.length;
      ignored += others;
      if (plays.length === 0 && unreadable.length === before) {
        const beside = others === 0 ? '' : `, only ${others} other file${others === 1 ? '' : 's'}`;
        unmatched.push(`${namedPath(path)}: the directory contains no *.gqr, *.ndjson or *.jsonl${beside}`);
      }
      const own = plays.map((file) => ({ path: file, hasLines: LINES.test(file), player: folderBelow(path, file) }));
      files.push(...sortedByPlay(own, (file) => file.path));
    }
  }
  if (unmatched.length > 0) {
    const what = unmatched.length === 1 ? 'a path of --plays has' : 'paths of --plays have';
    throw new Failure(
      `nothing was done: ${what} no plays\n${unmatched.map((line) => `  ${line}\n`).join('')}` +
        'expected plays (.gqr), NDJSON, or directories of them',
    );
  }
  const seen = new Set<string>();
  const once = files.filter(({ path }) => {
    const full = path === STDIN ? path : resolve(path);
    if (seen.has(full)) return false;
    seen.add(full);
    return true;
  });
  return { files: once, ignored, unreadable };
}

/** The folder of a file, from the directory in which it was found; null if that is the directory itself. */
function folderBelow(directory: string, file: string): string | null {
  const path = directory === '.' ? file : file.slice(directory.endsWith('/') ? directory.length : directory.length + 1);
  const end = path.lastIndexOf('/');
  return end < 0 ? null : path.slice(0, end);
}
