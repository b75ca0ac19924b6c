import { posix, relative } from 'node:path';
import process from 'node:process';
import { readConfig } from '../../schema/index.ts';
import { CONFIG_NAME, type ConfiguredTerms, findConfig, noConfiguration, termsIn, termsSaid } from '../config/index.ts';
import { FETCH_MORE, Git, readBytes } from '../io/index.ts';

/** What the working directory's configuration says about terms, as a commit or the index has it. An invalid one is ignored with a message. */
export function termsInTree(root: string, tree: string, label: string, messages: string[]): ConfiguredTerms {
  const here = relative(root, process.cwd()).replaceAll('\\', '/');
  const folders: string[] = [];
  for (let at = here; at !== '' && at !== '.'; at = posix.dirname(at)) folders.push(`${at}/`);
  const paths = [...folders, ''].map((folder) => folder + CONFIG_NAME);
  const found = readObjects(paths.map((path) => `${tree}:${path}`));
  const index = found.findIndex((bytes) => bytes !== null);
  const bytes = found[index];
  return bytes == null ? termsSaid(noConfiguration()) : termsOfBytes(bytes, `${paths[index]} in ${label}`, messages);
}

/** What the configuration that is nearest to a folder says about terms. */
export function termsOfFolder(folder: string, messages: string[]): ConfiguredTerms {
  const file = findConfig(folder);
  return file === null ? termsSaid(noConfiguration()) : termsOfBytes(readBytes(file), file, messages);
}

function termsOfBytes(bytes: Uint8Array, name: string, messages: string[]): ConfiguredTerms {
  const read = readConfig(bytes);
  if (read.ok) return termsIn(read.config);
  const [{ message, line }] = read.problems;
  messages.push(`warning: ${name} is not valid, and is left out: ${line === null ? '' : `line ${line}: `}${message}`);
  return termsSaid(noConfiguration());
}

/** git in the working directory. */
export const GIT = new Git('.', 'gq diff', 'give two files or two folders to compare');

/** Fields that end with NUL. */
export const splitNul = (bytes: Buffer): string[] => bytes.toString().split('\0').slice(0, -1);

/** The objects that names such as `HEAD:levels/a.level.json` or a hash stand for, in their order; null if there is none. */
export function readObjects(names: readonly string[]): (Uint8Array | null)[] {
  if (names.length === 0) return [];
  const bytes = GIT.read(['cat-file', '--batch'], `${names.join('\n')}\n`);
  const objects: (Uint8Array | null)[] = [];
  for (let at = 0; at < bytes.length; ) {
    const end = bytes.indexOf(10, at);
    const size = /^\S+ blob (\d+)$/.exec(bytes.toString('utf8', at, end))?.[1];
    at = end + 1;
    if (size === undefined) {
      objects.push(null);
      continue;
    }
    objects.push(bytes.subarray(at, at + Number(size)));
    at += Number(size) + 1;
  }
  return objects;
}

/** The tree of a revision; null if there is no such revision. */
export const treeOf = (revision: string): string | null =>
  revision.startsWith('-') ? null : GIT.line(['rev-parse', '--verify', '--quiet', '--end-of-options', `${revision}^{tree}`]);

/** Advice where history may be missing. */
export const shallowHint = (): string => (GIT.isShallow() ? `; ${FETCH_MORE}` : '');
