import { relative, resolve } from 'node:path';
import { findLevelFiles, ignoreOf, unreadableFolders } from '../find/index.ts';
import { type Contents, filesBelow, once, statOrError } from '../io/index.ts';
import { Failure, namedPath, systemReason } from '../terminal/index.ts';
import type { Plan } from './plan.ts';

/** The files and packs of a set, in its order. */
export async function setPaths(
  paths: readonly string[],
  { file, directory, patterns }: Plan['ignore'],
  contents: Contents,
): Promise<readonly string[]> {
  if (contents === 'plays') return playPaths(paths);
  const ignores = await ignoreOf({ directory: resolve(directory), ignore: patterns });
  const { files, unreadable } = await findLevelFiles(paths, { file, ignores });
  if (unreadable.length === 0) return files;
  throw unreadableFolders(unreadable);
}

/** What a configuration leaves out, for another process in the same working directory. */
export const ignoreFor = (configuration: {
  readonly file: string | null;
  readonly directory: string;
  readonly ignore: readonly string[];
}): Plan['ignore'] => ({
  file: configuration.file,
  directory: relative('', configuration.directory) || '.',
  patterns: [...configuration.ignore],
});

function playPaths(paths: readonly string[]): string[] {
  const files: string[] = [];
  const unreadable: { path: string; reason: string }[] = [];
  for (const path of paths) {
    const stats = statOrError(path);
    if (stats instanceof Error)
      throw new Failure(`${namedPath(path)}: ${systemReason(stats)}; expected plays (.gqr), directories of them, or packs`);
    if (!stats.isDirectory()) files.push(path);
    else files.push(...filesBelow(path, (name) => name.endsWith('.gqr'), unreadable));
  }
  if (unreadable.length > 0) throw unreadableFolders(unreadable);
  if (files.length === 0) throw new Failure(`no plays: expected *.gqr in ${paths.map(namedPath).join(', ')}`);
  return once(files);
}
