import { existsSync } from 'node:fs';
import { dirname, relative, resolve } from 'node:path';
import process from 'node:process';
import { isSame } from '../../schema/index.ts';
import { readConfiguration, termsSaid } from '../config/index.ts';
import { findLevelFiles } from '../find/index.ts';
import { readBytes, siblingHint, statOrError } from '../io/index.ts';
import { Failure, namedPath } from '../terminal/index.ts';
import { compareInGit, mergeBase, type Revisions } from './compare-git.ts';
import type { Comparison, FileVersion, Pair } from './comparison.ts';
import { GIT, shallowHint, termsOfFolder, treeOf } from './side-terms.ts';

/** What stands on the command line. */
interface DiffArguments {
  /** What stands before `--`, or all if there is none. */
  readonly words: readonly string[];
  /** What stands after `--`; null if there is none. */
  readonly paths: readonly string[] | null;
  /** Whether to compare what is in the index. */
  readonly staged: boolean;
}

const RANGE = /^(.*?)(\.{2,3})(.*)$/;

/**
 * Finds what to compare. Revisions stand before paths, as for `git diff`. Two files or two folders, without `--` and without
 * a revision, are compared with each other.
 * @throws Failure if an argument is neither a revision nor a path, or if it may be both
 */
export async function chooseComparison({ words, paths, staged }: DiffArguments): Promise<Comparison> {
  if (paths === null && !staged && words.length === 2 && words.every((word) => existsSync(word)) && !words.some(isBoth)) {
    return comparePaths(words[0], words[1]);
  }
  const isGit = GIT.workTree() !== null;
  if (!isGit && words.length > 0) expectPaths(words);
  const { revisions, rest } = splitWords(words, paths);
  return compareInGit(sidesOf(revisions, staged), [...rest, ...(paths ?? [])]);
}

/** Whether a word names both a file and a revision. */
const isBoth = (word: string): boolean => existsSync(word) && treeOfWord(word);

/** @throws Failure with the path that does not exist */
function expectPaths(words: readonly string[]): void {
  const missing = words.find((word) => !existsSync(word));
  if (missing === undefined) return;
  throw new Failure(
    `${namedPath(missing)}: no such file or directory${siblingHint(missing)}; this is not a git repository: expected two files or two folders`,
  );
}

/** Divides what stands before `--` into revisions and paths. */
function splitWords(
  words: readonly string[],
  paths: readonly string[] | null,
): { readonly revisions: readonly string[]; readonly rest: readonly string[] } {
  if (paths !== null) return { revisions: words, rest: [] };
  const revisions: string[] = [];
  for (const [i, word] of words.entries()) {
    const isRevision = treeOfWord(word);
    if (isRevision && existsSync(word)) {
      throw new Failure(
        `${word}: it is both a revision and a file: write gq diff ${word} -- for the revision, gq diff -- ${word} for the file`,
      );
    }
    if (isRevision) {
      revisions.push(word);
      continue;
    }
    const rest = words.slice(i);
    const unknown = rest.find((path) => !existsSync(path) && !/[*?]/.test(path));
    if (unknown === undefined) return { revisions, rest };
    throw new Failure(
      `${namedPath(unknown)}: expected a revision or a file, found neither${siblingHint(unknown)}; for a file that is gone, write -- before it${shallowHint()}`,
    );
  }
  return { revisions, rest: [] };
}

/** Whether a word is a revision or a range of revisions. */
function treeOfWord(word: string): boolean {
  if (GIT.line(['rev-parse', '--git-dir']) === null) return false;
  if (treeOf(word) !== null) return true;
  const [, from, , to] = RANGE.exec(word) ?? [];
  return from !== undefined && from + to !== '' && [from, to].every((end) => end === '' || treeOf(end) !== null);
}

function sidesOf(revisions: readonly string[], staged: boolean): Revisions {
  const range = revisions.map((word) => (treeOf(word) === null ? RANGE.exec(word) : null));
  const tooMany = (): Failure =>
    new Failure(`expected at most two revisions, found ${revisions.length}: ${revisions.join(' ')}; paths stand after --`);
  const here = staged ? 'index' : 'worktree';
  if (revisions.length > 2) throw tooMany();
  if (revisions.length === 1 && range[0] !== null) {
    const [, from, dots, to] = range[0];
    if (staged)
      throw new Failure(`--staged and ${revisions[0]} cannot be combined: --staged compares one revision with the index`);
    const [before, after] = [from || 'HEAD', to || 'HEAD'];
    return { before: dots === '...' ? mergeBase(before, after) : before, after };
  }
  if (range.some((match) => match !== null)) throw tooMany();
  if (revisions.length === 2) {
    if (staged) throw new Failure('--staged and two revisions cannot be combined: --staged compares one revision with the index');
    return { before: revisions[0], after: revisions[1] };
  }
  return { before: revisions[0] ?? null, after: here };
}

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
export async function compareFiles(before: string, after: string, name?: string): Promise<Comparison> {
  const read = (path: string): FileVersion | null => (NOTHING.test(path) ? null : { path: name ?? path, bytes: readBytes(path) });
  const pair = { before: read(before), after: read(after) };
  const isEqual = pair.before !== null && pair.after !== null && Buffer.compare(pair.before.bytes, pair.after.bytes) === 0;
  const configured = termsSaid(await readConfiguration({}, name === undefined ? process.cwd() : dirname(resolve(name))));
  return {
    before: { label: name === undefined ? before : `${name} before`, configured },
    after: { label: name === undefined ? after : `${name} after`, configured },
    pairs: isEqual || (pair.before === null && pair.after === null) ? [] : [pair],
    equal: [],
    messages: [],
  };
}

/** Compares the level files of two folders, by their paths in them, each under the terms of its own configuration. */
async function compareFolders(before: string, after: string): Promise<Comparison> {
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
async function comparePaths(before: string, after: string): Promise<Comparison> {
  const folders = [before, after].filter(isFolder);
  if (folders.length === 2) return compareFolders(before, after);
  if (folders.length === 0) return compareFiles(before, after);
  throw new Failure(`${folders[0]} is a folder: expected two files or two folders`);
}
