import { existsSync } from 'node:fs';
import { dirname, join, relative, resolve, sep } from 'node:path';
import type { Plugin } from 'vitest/config';

/** The rooms, and the folders that tests and benchmarks share, of which `tsc -b` and `tsc -b bench` write a module for each source. */
const BUILT = [
  ...['schema', 'engine', 'game', 'phaser', 'solver', 'check', 'picture', 'review', 'cli', 'bench'],
  ...['scenes', 'judges', 'attackers', 'interrupted'].map((folder) => `tests/${folder}`),
];

/** What Node loads by itself, without a transformation. */
export const BUILT_FILES = new RegExp(`/dist/(${BUILT.join('|')})/.*\\.js$`);

/**
 * Lets tests import the built module in `dist/` wherever they name its source: they test what is published, and run in a third
 * less time than with modules that Vite transforms, whose every import becomes a property of an object.
 * @param project - the folder of the project
 */
export function builtRooms(project: string): Plugin {
  return {
    name: 'built-rooms',
    enforce: 'pre',
    resolveId(id, importer) {
      if (importer === undefined || !id.startsWith('.') || !id.endsWith('.ts')) return null;
      const source = relative(project, resolve(dirname(importer), id))
        .split(sep)
        .join('/');
      if (!BUILT.some((folder) => source.startsWith(`${folder}/`))) return null;
      const built = join(project, 'dist', source.replace(/ts$/, 'js'));
      if (!existsSync(built))
        this.error(`${source} is not built: expected ${relative(project, built)}. Run npm test, which builds.`);
      return built;
    },
  };
}
