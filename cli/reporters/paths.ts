import { isAbsolute, relative, resolve, sep } from 'node:path';
import type { Places } from './reporter.ts';

const withSlashes = (path: string): string => (sep === '/' ? path : path.split(sep).join('/'));

/** A file below a folder. */
export interface PathBelow {
  readonly folder: string;
  /** Relative to the folder, with slashes. */
  readonly path: string;
}

/** A path relative to the first of some folders that contains it; null if none does. */
function below(folders: readonly string[], file: string, directory: string): PathBelow | null {
  for (const folder of folders) {
    const path = relative(folder, resolve(directory, file));
    const isOutside = path === '' || path === '..' || path.startsWith(`..${sep}`) || isAbsolute(path);
    if (!isOutside) return { folder, path: withSlashes(path) };
  }
  return null;
}

/** A path as GitHub wants it: relative to its workspace; else as it was given. */
export const pathInWorkspace = (file: string, { workspaces, directory }: Places): string =>
  below(workspaces, file, directory)?.path ?? withSlashes(file);

/** A path relative to the workspace of GitHub or the root of the repository; null if it is outside. */
export const pathInRepository = (file: string, { workspaces, root, directory }: Places): PathBelow | null =>
  below([...workspaces, root], file, directory);
