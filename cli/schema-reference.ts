import { existsSync } from 'node:fs';
import { dirname, join, relative, resolve, sep } from 'node:path';
import { readRegularFile } from './regular-file.ts';

const TOOLKIT = 'gravity-quest-toolkit';

/** bytes */
const LARGEST_MANIFEST = 1024 * 1024;

/**
 * What a level file in `directory` says in `$schema`: the path, with slashes, to the JSON Schema of the toolkit that the
 * project around it has installed, or is; null where there is none, since a path that leads out of a project holds on one machine only.
 */
export function schemaReference(directory: string): string | null {
  const from = resolve(directory);
  for (let at = from; ; at = dirname(at)) {
    const installed = join(at, 'node_modules', TOOLKIT);
    const home = existsSync(installed) ? installed : isToolkit(at) ? at : null;
    if (home !== null)
      return relative(from, join(home, 'schema', 'level.schema.json'))
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
    // no such file, or one that is no JSON: another project's business
    return false;
  }
}
