import { realpathSync } from 'node:fs';
import { resolve } from 'node:path';
import { repositoryOf } from '../io/index.ts';
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
