import { FETCH_MORE, Git } from '../io/index.ts';

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
