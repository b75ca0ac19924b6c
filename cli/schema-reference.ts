import { existsSync } from 'node:fs';
import { dirname, join, relative, resolve, sep } from 'node:path';
import { readRegularFile } from './io/index.ts';

const TOOLKIT = 'gravity-quest-toolkit';

/** bytes */
const LARGEST_MANIFEST = 1024 * 1024;

/**
 * The value of `$schema` for a file in `directory`: the path, with slashes, to the JSON Schema of the toolkit that the
 * surrounding project has installed, or that is the project itself. null if there is none: a path that leads out of the project
 * would work on this machine only.
 * @param content what the file has
 */
export function schemaReference(directory: string, content: 'level' | 'pack' = 'level'): string | null {
  const from = resolve(directory);
  for (let at = from; ; at = dirname(at)) {
    const installed = join(at, 'node_modules', TOOLKIT);
    const home = existsSync(installed) ? installed : isToolkit(at) ? at : null;
    if (home !== null)
      return relative(from, join(home, 'schema', `${content}.schema.json`))
        .split(sep)
        .join('/');
    if (dirname(at) === at) return null;
  }
}

function isToolkit(directory: string): boolean {
  try {
    return (
      JSON.parse(Buffer.from(readRegularFile(join(directory, 'package.json'), LARGEST_MANIFEST)).toString()).name === TOOLKIT
    );
  } catch {
    // no such file, or not JSON: that does not concern this project
    return false;
  }
}
