import { isAbsolute, relative, resolve, sep } from 'node:path';
import { realTarget, repositoryOf, systemReason } from './io/index.ts';

/** An absolute path of Windows: `C:\levels`, `\\server\levels`. Elsewhere it would be a strange name of a file. */
const OF_WINDOWS = /^(?:[A-Za-z]:|[\\/]{2})/;

/** The folder in which git keeps its own files, by any of its names on file systems that don't tell them apart. */
const OF_GIT = /^(?:\.git|git~\d+)[. ]*(?::.*)?$/i;

/** What a pattern of files begins with: the folders before its first wildcard. */
const fixedPart = (pattern: string): string => pattern.replace(/(?:^|[\\/])[^\\/]*[*?[{(!].*$/s, '');

/**
 * Why a path in a configuration must not be used: it may come from a stranger, and a command that runs in a clone must not touch
 * what is around it. Links count by where they lead.
 * @param folder the folder of the configuration, to which the path is relative
 * @param path a path, or a pattern of paths
 * @param read a folder besides, from which is only read: with `--config`, a configuration may be for levels beside it; null: none
 * @returns null if the path stays in the repository, outside of git's own files
 */
export function whyOutside(folder: string, path: string, read: string | null): string | null {
  if (OF_WINDOWS.test(path) && !isAbsolute(path)) return 'is an absolute path of Windows';
  try {
    const root = repositoryOf(realTarget(folder));
    const target = realTarget(resolve(folder, fixedPart(path)));
    const inside = [root, ...(read === null ? [] : [realTarget(read)])]
      .map((one) => relative(one, target))
      .find((way) => !isAbsolute(way) && way.split(sep)[0] !== '..');
    if (inside === undefined) return `leads to ${target}, outside of ${root}`;
    return inside.split(sep).some((part) => OF_GIT.test(part)) ? `leads to ${target}, among git's own files` : null;
  } catch (error) {
    return `leads to nowhere: ${systemReason(error)}`;
  }
}
