import { dirname, relative, resolve } from 'node:path';
import { isSame } from '../../schema/index.ts';
import { findLevelFiles } from '../find/index.ts';
import { Failure, readBytes, statOrError } from '../io/index.ts';
import { readConfiguration } from '../read-configuration.ts';
import { termsSaid } from '../terms.ts';
import type { Comparison, FileVersion, Pair } from './comparison.ts';
import { termsOfFolder } from './side-terms.ts';

/** The file that stands for no file in git's protocols. */
const NOTHING = /^(?:\/dev\/null|nul)$/i;

const isFolder = (path: string): boolean => {
  const stats = statOrError(path);
  return !(stats instanceof Error) && stats.isDirectory();
};

/**
 * Compares two level files.
 * @param name what to call the file in reports, its path in the repository: the configuration of its folder applies; by default each
 *   has its own path, and the configuration is that of the working directory
 */
export function compareFiles(before: string, after: string, name?: string): Comparison {
  const read = (path: string): FileVersion | null => (NOTHING.test(path) ? null : { path: name ?? path, bytes: readBytes(path) });
  const pair = { before: read(before), after: read(after) };
  const isEqual = pair.before !== null && pair.after !== null && Buffer.compare(pair.before.bytes, pair.after.bytes) === 0;
  const configured = termsSaid(name === undefined ? readConfiguration({}) : readConfiguration({}, dirname(resolve(name))));
  return {
    before: { label: name === undefined ? before : `${name} before`, configured },
    after: { label: name === undefined ? after : `${name} after`, configured },
    pairs: isEqual || (pair.before === null && pair.after === null) ? [] : [pair],
    equal: [],
    messages: [],
  };
}

/** Compares the level files of two folders, by their paths in them, each under the terms of its own configuration. */
export async function compareFolders(before: string, after: string): Promise<Comparison> {
  const messages: string[] = [];
  const list = async (folder: string): Promise<Map<string, FileVersion>> => {
    const { files, unreadable } = await findLevelFiles([folder]);
    for (const { path, reason } of unreadable) throw new Failure(`${path}: the folder can't be read: ${reason}`);
    return new Map(files.map((path) => [relative(folder, path).replaceAll('\\', '/'), { path, bytes: readBytes(path) }]));
  };
  const [earlier, later] = [await list(before), await list(after)];
  const sides = [before, after].map((folder) => ({ label: folder, configured: termsOfFolder(folder, messages) }));
  const names = [...new Set([...earlier.keys(), ...later.keys()])].sort((a, b) => (a < b ? -1 : 1));
  const all = names.map((name): Pair => ({ before: earlier.get(name) ?? null, after: later.get(name) ?? null }));
  const isEqual = ({ before: b, after: a }: Pair): boolean => b !== null && a !== null && Buffer.compare(b.bytes, a.bytes) === 0;
  const differ = !isSame(sides[0].configured, sides[1].configured);
  return {
    before: sides[0],
    after: sides[1],
    pairs: all.filter((pair) => !isEqual(pair)),
    equal: differ ? all.filter(isEqual).flatMap(({ after: a }) => (a === null ? [] : [a])) : [],
    messages,
  };
}

/**
 * Compares two files, or two folders.
 * @throws Failure for a file and a folder
 */
export async function comparePaths(before: string, after: string): Promise<Comparison> {
  const folders = [before, after].filter(isFolder);
  if (folders.length === 2) return compareFolders(before, after);
  if (folders.length === 0) return compareFiles(before, after);
  throw new Failure(`${folders[0]} is a folder: expected two files or two folders`);
}
