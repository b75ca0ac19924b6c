import { isAbsolute, relative, resolve, sep } from 'node:path';
import { entryName } from '../io/index.ts';
import type { Places } from './reporter.ts';

const withSlashes = (path: string): string => (sep === '/' ? path : path.split(sep).join('/'));

/** A path relative to the first of some folders that contains it, with slashes; null if none does. */
function below(folders: readonly string[], file: string, directory: string): string | null {
  // the name of an entry of a pack is no path: dots in it lead nowhere
  const { pack, label } = entryName(file) ?? { pack: file, label: null };
  for (const folder of folders) {
    const path = relative(folder, resolve(directory, pack));
    const isOutside = path === '' || path === '..' || path.startsWith(`..${sep}`) || isAbsolute(path);
    if (!isOutside) return label === null ? withSlashes(path) : `${withSlashes(path)}#${label}`;
  }
  return null;
}

/** A path as GitHub wants it: relative to its workspace; else as it was given. */
export const pathInWorkspace = (file: string, { workspaces, directory }: Places): string =>
  below(workspaces, file, directory) ?? withSlashes(file);

/** What a service takes for the root of the repository: GitHub's workspace, else the repository itself. */
export const rootOf = ({ workspaces, root }: Places): string => workspaces[0] ?? root;

/** A path relative to that root; null if it is outside. */
export const pathInRepository = (file: string, { workspaces, root, directory }: Places): string | null =>
  below(workspaces.length > 0 ? workspaces : [root], file, directory);
