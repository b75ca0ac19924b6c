import { createHash } from 'node:crypto';
import { lstatSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { isAbsolute, join, relative, sep } from 'node:path';

/** Everything the page is made of: folders with all their files, and files. */
export const SOURCES = [
  'check',
  'editor',
  'engine',
  'game',
  'levels',
  'phaser',
  'picture',
  'review',
  'schema',
  'solver',
  'package-lock.json',
  'package.json',
  'tsconfig.base.json',
];

/** Everything the game of `gq build` is made of. */
export const SITE_SOURCES = [
  'engine',
  'examples/phaser/index.html',
  'examples/phaser/src',
  'examples/phaser/vite.config.ts',
  'game',
  'levels',
  'phaser',
  'schema',
  'package-lock.json',
  'package.json',
  'tsconfig.base.json',
];

/**
 * A hash of the names and texts of all sources in a project, and of the version of Node. Names that begin with a dot are left out.
 * @param {string} project
 * @param {readonly string[]} sources
 */
export function fingerprint(project, sources = SOURCES) {
  const hash = createHash('sha256').update(process.version);
  const add = (/** @type {string} */ path) => {
    const full = join(project, path);
    if (lstatSync(full, { throwIfNoEntry: false })?.isDirectory())
      for (const name of readdirSync(full).sort()) name.startsWith('.') || add(join(path, name));
    // pipes, and links to folders or to nothing, may stand in a folder of levels, and are no part of the page
    else if (statSync(full, { throwIfNoEntry: false })?.isFile()) hash.update(`\0${path}\0`).update(readFileSync(full));
  };
  for (const path of sources) add(path);
  return hash.digest('hex');
}

/**
 * Whether a module is among the sources, in a package, which package-lock.json names, or made up by the bundler.
 * @param {string} project
 * @param {string} id as the bundler has it, perhaps with a query
 */
export const isSource = (project, id) => isIn(SOURCES, pathOf(project, id));

/**
 * The same for the game of `gq build`, which is made of rooms as they are compiled.
 * @param {string} project
 * @param {string} id
 */
export const isSiteSource = (project, id) => isIn(SITE_SOURCES, pathOf(project, id)?.replace(/^dist\//, '') ?? null);

/**
 * @param {readonly string[]} sources
 * @param {string | null} path
 */
function isIn(sources, path) {
  if (path === null || path.split('/').includes('node_modules')) return true;
  return sources.some((source) => path === source || path.startsWith(`${source}/`));
}

/**
 * The path of a module in the project, with slashes; null if the bundler has made it up.
 * @param {string} project
 * @param {string} id
 */
function pathOf(project, id) {
  const file = id.replace(/\?.*$/, '');
  return isAbsolute(file) ? relative(project, file).split(sep).join('/') : null;
}
