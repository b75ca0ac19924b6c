import { type Dirent, readdirSync, realpathSync, type Stats, statSync } from 'node:fs';
import { resolve, sep } from 'node:path';
import { Failure, systemReason } from './failure.ts';
import { namedPath } from './shown-path.ts';

const LEVEL_FILE = /\.level\.json$/;

export interface FoundFiles {
  /** Paths as they were given, a directory's files below it sorted by path; each file once. */
  readonly files: readonly string[];
  /** Parts of a directory that could not be looked into. */
  readonly unreadable: readonly { readonly path: string; readonly reason: string }[];
}

/**
 * The level files that paths stand for. A file is taken whatever its name; a directory stands for every `*.level.json`
 * below it, but for hidden directories and node_modules; a path with `*`, `**` or `?` that names no file, for what matches it.
 * @throws Failure naming every path that stands for nothing
 */
export async function findLevelFiles(paths: readonly string[]): Promise<FoundFiles> {
  const files: string[] = [];
  const unreadable: { path: string; reason: string }[] = [];
  const unmatched: string[] = [];
  for (const path of paths) {
    const found = await expand(path, unreadable);
    if (typeof found === 'string') unmatched.push(`${namedPath(path)}: ${found}`);
    else for (const file of found) files.push(file);
  }
  if (unmatched.length > 0) {
    const hint = 'expected a level file, a directory that contains *.level.json, or a pattern like "levels/*.json"';
    throw new Failure(
      `nothing was done: ${unmatched.length === 1 ? 'a path matches' : 'paths match'} no level file\n${unmatched.map((u) => `  ${u}\n`).join('')}${hint}`,
    );
  }
  return { files: once(files), unreadable };
}

/** The files that a path stands for, or why it stands for none. */
async function expand(path: string, unreadable: { path: string; reason: string }[]): Promise<string[] | string> {
  const before = unreadable.length;
  const stats = statOrError(path);
  if (!(stats instanceof Error)) {
    if (!stats.isDirectory()) return [path];
    const found = walk(path, (name) => LEVEL_FILE.test(name), unreadable);
    return found.length > 0 || unreadable.length > before ? found : 'the directory contains no *.level.json';
  }
  if (!/[*?]/.test(path)) {
    // with it comes the schema, which a check leaves to its workers
    const { siblingHint } = await import('./sibling-hint.ts');
    return systemReason(stats) + siblingHint(path);
  }
  const pattern = path.split(sep).join('/');
  const fixed = pattern.slice(0, pattern.search(/[*?]/));
  const root = fixed.includes('/') ? fixed.slice(0, fixed.lastIndexOf('/') + 1) : '.';
  if (statOrError(root) instanceof Error) return `there is no directory ${root}`;
  const matches = globToRegExp(pattern);
  const found = walk(root, () => true, unreadable).filter((file) => matches.test(file));
  return found.length > 0 || unreadable.length > before ? found : 'no file matches this pattern';
}

/** Every file below a directory whose path passes, sorted by path; follows links, but goes into no directory twice. */
function walk(root: string, passes: (path: string) => boolean, unreadable: { path: string; reason: string }[]): string[] {
  const found: string[] = [];
  const seen = new Set<string>();
  const pending = [root];
  for (let directory = pending.pop(); directory !== undefined; directory = pending.pop()) {
    let entries: Dirent[];
    try {
      const real = realpathSync(directory);
      if (seen.has(real)) continue;
      seen.add(real);
      entries = readdirSync(directory, { withFileTypes: true });
    } catch (error) {
      unreadable.push({ path: directory, reason: systemReason(error) });
      continue;
    }
    const prefix = directory === '.' ? '' : directory.endsWith('/') ? directory : `${directory}/`;
    for (const entry of entries) {
      const path = prefix + entry.name;
      const kind = entry.isSymbolicLink() ? statOrError(path) : entry;
      if (!(kind instanceof Error) && kind.isDirectory()) {
        if (!entry.name.startsWith('.') && entry.name !== 'node_modules') pending.push(path);
      } else if (passes(path) && (kind instanceof Error || kind.isFile())) {
        // a link that leads nowhere is kept: reading it says what is wrong
        found.push(path);
      }
    }
  }
  return found.sort((a, b) => (a < b ? -1 : a > b ? 1 : 0));
}

/** `*` and `?` stand for characters of one name, `**` for any directories. */
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

function once(files: readonly string[]): string[] {
  const seen = new Set<string>();
  return files.filter((file) => {
    const full = resolve(file);
    if (seen.has(full)) return false;
    seen.add(full);
    return true;
  });
}

/** What stands at a path, or why that can't be said. */
export function statOrError(path: string): Stats | Error {
  try {
    return statSync(path);
  } catch (error) {
    return error as Error;
  }
}
