import { createHash } from 'node:crypto';
import { lstatSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { isAbsolute, join, relative, sep } from 'node:path';

/** Everything the page is made of: folders with all their files, and files. */
export const SOURCES = [
  'check',
  'editor',
  'engine',
  'levels',

  'picture',
  'review',
  'schema',
  'solver',
  'package-lock.json',
  'package.json',
  'tsconfig.base.json',
];

/**
 * A hash of the names and texts of all sources in a project, and of the version of Node. Names that begin with a dot are left out.
 * @param {string} project
 */
export function fingerprint(project) {
  const hash = createHash('sha256').update(process.version);
  const add = (/** @type {string} */ path) => {
    const full = join(project, path);
    if (lstatSync(full, { throwIfNoEntry: false })?.isDirectory())
      for (const name of readdirSync(full).sort()) name.startsWith('.') || add(join(path, name));
    // pipes, and links to folders or to nothing, may stand in a folder of levels, and are no part of the page
    else if (statSync(full, { throwIfNoEntry: false })?.isFile()) hash.update(`\0${path}\0`).update(readFileSync(full));
  };
  for (const path of SOURCES) add(path);
  return hash.digest('hex');
}

/**
 * Whether a module is among the sources, in a package, which package-lock.json names, or made up by the bundler.
 * @param {string} project
 * @param {string} id as the bundler has it, perhaps with a query
 */
export function isSource(project, id) {
  const file = id.replace(/\?.*$/, '');
  if (!isAbsolute(file)) return true;
  const path = relative(project, file);
  return path.split(sep).includes('node_modules') || SOURCES.includes(path.split(sep)[0]);
}
