import { existsSync, realpathSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import type { Places } from './reporter.ts';

/** The folders to which paths in reports are relative. */
export function placesOf(directory: string, { GITHUB_WORKSPACE }: NodeJS.ProcessEnv): Places {
  const given = GITHUB_WORKSPACE ? [resolve(directory, GITHUB_WORKSPACE)] : [];
  return { directory, workspaces: [...new Set(given.flatMap((path) => [path, real(path)]))], root: repositoryOf(directory) };
}

/** A working directory is known by its real path, while a variable may name a link to it. */
function real(path: string): string {
  try {
    return realpathSync(path);
  } catch {
    return path;
  }
}

/** The root of the repository around a folder; the folder itself if there is none. */
function repositoryOf(directory: string): string {
  for (let at = directory; ; at = dirname(at)) {
    if (existsSync(join(at, '.git'))) return at;
    if (dirname(at) === at) return directory;
  }
}
