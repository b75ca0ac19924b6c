import { basename, join, relative, resolve, sep } from 'node:path';
import { MAX_FILE_SIZE } from '../../schema/basics/index.ts';
import type { Configuration } from '../config/index.ts';
import {
  entryName,
  type FoundPack,
  filesBelow,
  isPackFile,
  NOT_A_LEVEL,
  once,
  packFileOf,
  packFormat,
  readRegularFile,
  siblingHint,
  statOrError,
} from '../io/index.ts';
import { Failure, namedPath, shellPath, systemReason } from '../terminal/index.ts';

const LEVEL_FILE = /\.level\.json$/;

export interface FoundFiles {
  /** Each file once, in the order of the given paths; the files of a directory are sorted by path, or as its pack says. */
  readonly files: readonly string[];
  /** The pack files of the directories that are given. */
  readonly packs: readonly FoundPack[];
  /** Directories that could not be read. */
  readonly unreadable: readonly { readonly path: string; readonly reason: string }[];
}

/** That directories can't be read, where nothing can be done without them. */
export const unreadableFolders = (folders: FoundFiles['unreadable']): Failure =>
  new Failure(folders.map(({ path, reason }) => `${namedPath(path)}: the directory can't be read: ${reason}`).join('\n'));

/** Why nothing is found at a path, with a name that is nearly the same. */
export const whyMissing = (path: string, error: NodeJS.ErrnoException): string =>
  systemReason(error) + (error.code === 'ENOENT' ? siblingHint(path) : '');

/** That paths name nothing that a command works on. @param unmatched the paths, each with the reason */
export const nothingFound = (what: string, unmatched: readonly string[], expected: string): Failure =>
  new Failure(`${what}\n${unmatched.map((line) => `  ${line}\n`).join('')}${expected}`);

/** What a configuration leaves out, and which file says so. */
interface LeftOut {
  readonly file: string | null;
  readonly ignores: Ignore;
}

/**
 * Finds the level files that paths name. A file counts whatever its name; a directory stands for every `*.level.json` below it,
 * except in hidden directories and node_modules; a path with `*`, `**` or `?` that is not a file is a pattern.
 * @param leftOut files that are left out of directories and patterns; a file that is named counts all the same
 * @throws Failure with every path that matches nothing, or only what is left out
 */
export async function findLevelFiles(paths: readonly string[], leftOut: LeftOut | null = null): Promise<FoundFiles> {
  const files: string[] = [];
  const unreadable: { path: string; reason: string }[] = [];
  const unmatched: string[] = [];
  const packs: FoundPack[] = [];
  for (const path of paths) {
    const found = await expand(path, unreadable, packs, leftOut);
    if (typeof found === 'string') unmatched.push(`${namedPath(path)}: ${found}`);
    else for (const file of found) files.push(file);
  }
  if (unmatched.length > 0) {
    const what = unmatched.length === 1 ? 'a path matches no level file' : 'paths match no level file';
    const expected = 'expected a level file, a directory that contains *.level.json, or a pattern like "levels/*.json"';
    throw nothingFound(`nothing was done: ${what}`, unmatched, expected);
  }
  return { files: once(files), packs, unreadable };
}

/** The files that a path names, or why there are none. */
async function expand(
  path: string,
  unreadable: { path: string; reason: string }[],
  packs: FoundPack[],
  leftOut: LeftOut | null,
): Promise<string[] | string> {
  const before = unreadable.length;
  const stats = statOrError(path);
  if (!(stats instanceof Error)) {
    if (!stats.isDirectory()) return isPackFile(path) ? NOT_A_LEVEL : [path];
    const found = filesBelow(path, (name) => LEVEL_FILE.test(name), unreadable);
    if (found.length > 0 || unreadable.length > before) return without(await inOrder(path, found, packs), leftOut);
    const near = nearLevelsHint(filesBelow(path, isNearlyLevelName, []));
    return `the directory contains no *.level.json${near}${packsHint(path)}`;
  }
  const entry = entryName(path);
  if (entry !== null && !(statOrError(entry.pack) instanceof Error)) return [path];
  if (!/[*?]/.test(path)) {
    return whyMissing(path, stats);
  }
  const pattern = path.split(sep).join('/');
  const fixed = pattern.slice(0, pattern.search(/[*?]/));
  const root = fixed.includes('/') ? fixed.slice(0, fixed.lastIndexOf('/') + 1) : '.';
  if (statOrError(root) instanceof Error) return `there is no directory ${root}`;
  const matches = globToRegExp(pattern);
  const found = filesBelow(root, (file) => !isPackFile(file), unreadable).filter((file) => matches.test(file));
  return found.length > 0 || unreadable.length > before ? without(found, leftOut) : 'no file matches this pattern';
}

/** The files of a directory in the order of its pack, if it has one. */
async function inOrder(folder: string, files: string[], packs: FoundPack[]): Promise<string[]> {
  const file = packFileOf(folder);
  if (file === null) return files;
  if (!packs.some((pack) => resolve(pack.file) === resolve(file))) packs.push({ file, folder, levels: files });
  // only a folder with a pack file pays for the schema
  const { orderFiles } = await import('../pack-file/index.ts');
  return orderFiles(files, folder, file);
}

/** The files that are not left out, or why there are none. */
function without(files: string[], leftOut: LeftOut | null): string[] | string {
  if (leftOut === null) return files;
  const counts = new Map<string, number>();
  const kept = files.filter((file) => {
    const pattern = leftOut.ignores(file);
    if (pattern !== null) counts.set(pattern, (counts.get(pattern) ?? 0) + 1);
    return pattern === null;
  });
  if (kept.length > 0 || files.length === 0) return kept;
  const by = [...counts].map(([pattern, count]) => `${JSON.stringify(pattern)} ignores ${count}`).join(', ');
  return `all its level files are ignored: in ${leftOut.file}, ${by}; name a file to check it all the same, or use --no-config`;
}

/** Compiles a pattern: `*` and `?` match characters of one name, `**` matches any directories. */
function globToRegExp(pattern: string): RegExp {
  const source = pattern.replace(/\*\*\/|\*+|\?|[^*?]+/g, (part) => {
    if (part === '**/') return '(?:.*/)?';
    if (part.startsWith('**')) return '.*';
    if (part === '*') return '[^/]*';
    if (part === '?') return '[^/]';
    return part.replace(/[.+^${}()|[\]\\]/g, '\\$&');
  });
  return new RegExp(`^${source}$`, 'su');
}

/** For a directory without a level file: that packs in it are to be named. */
function packsHint(directory: string): string {
  const [pack, ...more] = filesBelow(directory, (name) => packFormat(name) !== null, []);
  if (pack === undefined) return '';
  const count = more.length === 0 ? 'a pack' : `${more.length + 1} packs`;
  return `; it has ${count}, which must be named: ${shellPath(pack)}`;
}

/** The help of an argument for paths. */
export const PATHS =
  'level files, directories, or quoted patterns with * ** ? (default: "levels" of gq.config.json, else levels)';

/**
 * The paths that a command works on: those that are given, else those of the configuration, else `levels`.
 */
export const pathsOr = (paths: readonly string[], { levels }: Pick<Configuration, 'levels'>): readonly string[] =>
  paths.length > 0 ? paths : (levels ?? ['levels']);

/**
 * Finds the level files that a command works on, without those that the configuration leaves out.
 * @throws Failure with every path that matches nothing, or only what is left out
 */
export async function findConfigured(paths: readonly string[], configuration: Configuration): Promise<FoundFiles> {
  const { file, levels } = configuration;
  try {
    return await findLevelFiles(pathsOr(paths, configuration), { file, ignores: await ignoreOf(configuration) });
  } catch (error) {
    if (!(error instanceof Failure) || paths.length > 0 || levels === null) throw error;
    throw new Failure(`${error.message}\nno path was given, so "levels" of ${file} counts`);
  }
}

/** Finds the pattern of a configuration that leaves a file out; null if none does. */
export type Ignore = (file: string) => string | null;

interface Pattern {
  readonly text: string;
  /** Whether it takes files back in that an earlier pattern leaves out. */
  readonly isNegated: boolean;
  readonly onlyDirectories: boolean;
  readonly matches: (path: string) => boolean;
}

/**
 * The patterns of a configuration, as in .gitignore: without a slash they match a name at any depth, with one a path from the
 * directory of the configuration; a directory stands for everything below it; `!` takes back; the last pattern that matches
 * decides. Other than there, a file below a directory that is left out can be taken back.
 */
export async function ignoreOf({ directory, ignore }: Pick<Configuration, 'directory' | 'ignore'>): Promise<Ignore> {
  if (ignore.length === 0) return () => null;
  // only a configuration with patterns pays for it
  const { default: picomatch } = await import('picomatch');
  const patterns = ignore.map((text): Pattern => {
    const isNegated = text.startsWith('!');
    const body = text.slice(isNegated ? 1 : 0).replace(/^(?:\.\/)+/, '');
    const onlyDirectories = body.endsWith('/');
    const plain = body.replace(/\/+$/, '').replace(/^\/+/, '');
    const glob = body.replace(/\/+$/, '').includes('/') ? plain : `**/${plain}`;
    const isMatch = picomatch(glob, { dot: true, nonegate: true });
    return { text, isNegated, onlyDirectories, matches: (path) => isMatch(path) };
  });
  return (file) => {
    const path = relative(directory, resolve(file)).split(sep).join('/');
    const steps = path.split('/');
    const directories = steps.slice(1).map((_, i) => steps.slice(0, i + 1).join('/'));
    let last: Pattern | null = null;
    for (const pattern of patterns) {
      if (directories.some((one) => pattern.matches(one)) || (!pattern.onlyDirectories && pattern.matches(path))) last = pattern;
    }
    return last === null || last.isNegated ? null : last.text;
  };
}

/** A name that is nearly that of a level file: `far.json`, `far.level.json.txt`, `far.level.txt`. */
const NEARLY = /^([^.].*?)(?:\.level)?\.json$|^([^.].*?)\.level(?:\.json)?(?:\.\w+)?$/i;

/** Files that are opened to see whether they hold a level, and those that a message names. */
const MOST_OPENED = 100;
const MOST_NAMED = 3;

export const isNearlyLevelName = (path: string): boolean => NEARLY.test(basename(path));

/** What a file should be called to be found in a directory. */
function levelName(path: string): string {
  const [, ofJson, ofLevel] = NEARLY.exec(basename(path)) ?? [];
  return `${ofJson ?? ofLevel}.level.json`;
}

/** Whether a file holds what every level has; one that cannot be read is none. */
function looksLikeLevel(path: string): boolean {
  try {
    const text = Buffer.from(readRegularFile(path, MAX_FILE_SIZE)).toString();
    return text.includes('"blackHole"') && text.includes('"astronaut"');
  } catch {
    return false;
  }
}

/** For a directory without a level file: `; far.json looks like a level: …` for each file that only has another name, else nothing. */
export function nearLevelsHint(files: readonly string[]): string {
  const near = files.slice(0, MOST_OPENED).filter(looksLikeLevel);
  const named = near
    .slice(0, MOST_NAMED)
    .map((path) => `; ${join(path)} looks like a level: did you mean to call it ${levelName(path)}?`);
  return named.join('') + (near.length > MOST_NAMED ? `; and ${near.length - MOST_NAMED} more` : '');
}
