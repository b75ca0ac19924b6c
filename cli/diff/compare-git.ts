import { readFileSync, statSync } from 'node:fs';
import { relative, resolve } from 'node:path';
import process from 'node:process';
import { isSame, MAX_FILE_SIZE } from '../../schema/index.ts';
import { readConfiguration, termsSaid } from '../config/index.ts';
import { Failure, namedPath } from '../terminal/index.ts';
import type { Comparison, FileVersion, Pair, Side } from './comparison.ts';
import { GIT, readObjects, shallowHint, splitNul, termsInTree, treeOf } from './side-terms.ts';

/** What is compared with what. */
export interface Revisions {
  /** The earlier side; null: HEAD, or nothing where there is no commit yet. */
  readonly before: string | null;
  /** The later side: a revision, or what is in the folder or in the index. */
  readonly after: string | 'worktree' | 'index';
}

const LEVEL_NAME = /\.level\.json$/;
const NO_OBJECT = /^0+$/;
const REGULAR = /^100/;

/**
 * Compares the level files of two revisions, or of a revision and the working tree.
 * @param paths limits the comparison: files, folders and patterns, as git reads them
 * @throws Failure outside of a repository, for unknown revisions, and with every path that matches no level file
 */
export async function compareInGit({ before, after }: Revisions, paths: readonly string[]): Promise<Comparison> {
  const root = GIT.workTree();
  if (root === null) {
    throw new Failure(
      `${process.cwd()} is not in a git repository: expected two files or two folders to compare, for example gq diff old.level.json new.level.json`,
    );
  }
  const messages: string[] = [];
  const from = before === null && treeOf('HEAD') === null ? emptyTree() : treeOrFail(before ?? 'HEAD');
  const isTree = after !== 'worktree' && after !== 'index';
  const to = isTree ? treeOrFail(after) : null;
  const others = to !== null ? [from, to] : after === 'index' ? ['--cached', from] : [from];
  const specs = paths.length === 0 ? [':(top,glob)**/*.level.json'] : paths;
  const isLevel = levelFilter(root, paths);

  const all = changedFiles(others, specs).filter(({ before: b, after: a }) => isLevel(b?.path) || isLevel(a?.path));
  // the index has several versions of a file with conflicts, and what is on disk is none of them
  const isOpen = ({ isUnmerged }: ChangedFile): boolean => isUnmerged && after === 'index';
  const changed = all.filter((file) => !isOpen(file));
  const untracked = after === 'worktree' ? untrackedFiles(specs).filter(isLevel) : [];
  const shown = (path: string): string => relative('', resolve(root, path)).replaceAll('\\', '/');
  for (const { after: open } of all.filter(isOpen)) {
    const path = namedPath(shown(open?.path ?? ''));
    messages.push(`${path} is not compared: git has conflicts in it, and nothing of it is staged until git add`);
  }
  const blobs = [...new Set(changed.flatMap((file) => [file.before?.blob, file.after?.blob]).filter((blob) => blob != null))];
  const objects = new Map(readObjects(blobs).map((bytes, i) => [blobs[i], bytes]));
  const read = (file: ChangedSide | null): FileVersion | null => {
    if (file === null) return null;
    const path = shown(file.path);
    if (file.blob === null) return onDisk(resolve(root, file.path), path);
    const bytes = objects.get(file.blob);
    if (bytes == null) throw new Failure(`${path}: git does not have its content (${file.blob})${shallowHint()}`);
    return { path, bytes };
  };
  const pairs = [
    ...changed.map((file): Pair => ({ before: read(file.before), after: read(file.after) })),
    ...untracked.map((path): Pair => ({ before: null, after: onDisk(resolve(root, path), shown(path)) })),
  ].filter((pair) => pair.before !== null || pair.after !== null);

  const tree = to ?? '';
  const sides: [Side, Side] = [
    { label: before ?? 'HEAD', configured: termsInTree(root, from, before ?? 'HEAD', messages) },
    after === 'worktree'
      ? { label: 'the working tree', configured: termsSaid(await readConfiguration({})) }
      : { label: isTree ? after : 'the index', configured: termsInTree(root, tree, isTree ? after : 'the index', messages) },
  ];
  const differ = !isSame(sides[0].configured, sides[1].configured);
  if (paths.length > 0) expectMatches(paths, [from, ...(to === null ? [] : [to])], to === null, isLevel);
  const equal = differ ? equalFiles(from, specs, pairs, isLevel, shown) : [];
  return { before: sides[0], after: sides[1], pairs, equal, messages };
}

interface ChangedSide {
  /** From the root of the repository. */
  readonly path: string;
  /** Its object; null for the file on disk. */
  readonly blob: string | null;
}

interface ChangedFile {
  readonly before: ChangedSide | null;
  readonly after: ChangedSide | null;
  /** Whether git has conflicts in it. */
  readonly isUnmerged: boolean;
}

/** The files that differ, as git says. */
function changedFiles(others: readonly string[], specs: readonly string[]): ChangedFile[] {
  const options = ['--raw', '-z', '--no-abbrev', '--find-renames', '--no-relative', '--no-ext-diff', '--ignore-submodules'];
  const fields = splitNul(GIT.read(['diff', ...options, ...others, '--', ...specs]));
  const files = new Map<string, ChangedFile>();
  for (let i = 0; i < fields.length; ) {
    const [modeBefore, modeAfter, blobBefore, blobAfter, status] = fields[i++].slice(1).split(' ');
    const path = fields[i++];
    const later = /^[RC]/.test(status) ? fields[i++] : path;
    const side = (mode: string, blob: string, at: string): ChangedSide | null =>
      REGULAR.test(mode) ? { path: at, blob: NO_OBJECT.test(blob) ? null : blob } : null;
    // a file with conflicts has a second entry that compares what is on disk
    if (status === 'U') {
      if (!files.has(path)) files.set(path, { before: null, after: { path, blob: null }, isUnmerged: true });
      continue;
    }
    const before = status === 'A' ? null : side(modeBefore, blobBefore, path);
    files.set(later, { before, after: status === 'D' ? null : side(modeAfter, blobAfter, later), isUnmerged: false });
  }
  return [...files.values()];
}

const untrackedFiles = (specs: readonly string[]): string[] =>
  splitNul(GIT.read(['ls-files', '-z', '--others', '--exclude-standard', '--full-name', '--', ...specs]));

/** A file on disk; null if it is not a file, or not there any more. */
function onDisk(file: string, path: string): FileVersion | null {
  const stats = statSync(file, { throwIfNoEntry: false });
  if (stats?.isFile() !== true) return null;
  // readers refuse a file that is larger
  return { path, bytes: readFileSync(file).subarray(0, MAX_FILE_SIZE + 1) };
}

/** Whether a path from the root is that of a level: by its name, or because it was named. */
function levelFilter(root: string, paths: readonly string[]): (path: string | undefined) => boolean {
  const named = new Set(paths.map((path) => relative(root, resolve(path)).replaceAll('\\', '/')));
  return (path) => path !== undefined && (LEVEL_NAME.test(path) || named.has(path));
}

/** @throws Failure with each path that matches no level file in any of the trees */
function expectMatches(
  paths: readonly string[],
  trees: readonly string[],
  isDisk: boolean,
  isLevel: (path: string) => boolean,
): void {
  const none = emptyTree();
  const unmatched = paths.filter((path) => {
    const found = trees.some((tree) =>
      splitNul(GIT.read(['diff', '--name-only', '-z', '--no-relative', none, tree, '--', path])).some(isLevel),
    );
    if (found || !isDisk) return !found;
    return !splitNul(GIT.read(['ls-files', '-z', '--cached', '--others', '--exclude-standard', '--full-name', '--', path])).some(
      isLevel,
    );
  });
  if (unmatched.length === 0) return;
  throw new Failure(
    `nothing was compared: ${unmatched.length === 1 ? 'a path matches' : 'paths match'} no level file on either side\n` +
      `${unmatched.map((path) => `  ${namedPath(path)}\n`).join('')}expected a level file, a folder that contains *.level.json, or a pattern like "levels/*.json"`,
  );
}

/** The level files that do not differ. */
function equalFiles(
  tree: string,
  specs: readonly string[],
  pairs: readonly Pair[],
  isLevel: (path: string) => boolean,
  shown: (path: string) => string,
): FileVersion[] {
  const different = new Set(pairs.map(({ before }) => before?.path));
  const listed = splitNul(GIT.read(['diff', '--name-only', '-z', '--no-relative', emptyTree(), tree, '--', ...specs]))
    .filter(isLevel)
    .filter((path) => !different.has(shown(path)));
  return readObjects(listed.map((path) => `${tree}:${path}`)).flatMap((bytes, i) =>
    bytes === null ? [] : [{ path: shown(listed[i]), bytes }],
  );
}

const emptyTree = (): string => GIT.read(['hash-object', '-t', 'tree', '--stdin'], '').toString().trim();

function treeOrFail(revision: string): string {
  const tree = treeOf(revision);
  if (tree !== null) return tree;
  if (revision === 'HEAD')
    throw new Failure(`there is no commit yet: expected two files or two folders to compare${shallowHint()}`);
  throw new Failure(`${namedPath(revision)}: expected a commit, branch or tag, found no such revision${shallowHint()}`);
}

/** The commit at which two branches parted. @throws Failure if they have none in common */
export function mergeBase(one: string, other: string): string {
  treeOrFail(one);
  treeOrFail(other);
  const base = GIT.line(['merge-base', one, other]);
  if (base !== null) return base;
  throw new Failure(`${one} and ${other} have no commit in common${shallowHint()}`);
}
