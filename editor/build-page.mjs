// Builds the page, unless what it is made of is the same as in the last build: that takes 10 s.
import { createHash } from 'node:crypto';
import { existsSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

/** Everything the page is made of: folders with all their files, and files. */
export const SOURCES = [
  'check',
  'editor',
  'engine',
  'levels',
  'picture',
  'schema',
  'solver',
  'package-lock.json',
  'package.json',
  'tsconfig.base.json',
];

/**
 * A hash of the names and texts of all sources in a project, and of the version of Node.
 * @param {string} project
 */
export function fingerprint(project) {
  const hash = createHash('sha256').update(process.version);
  const add = (/** @type {string} */ path) => {
    const full = join(project, path);
    if (statSync(full).isDirectory()) for (const name of readdirSync(full).sort()) add(join(path, name));
    else hash.update(`\0${path}\0`).update(readFileSync(full));
  };
  for (const path of SOURCES) add(path);
  return hash.digest('hex');
}

/**
 * Whether a module is among the sources, or in a package, which package-lock.json names.
 * @param {string} project
 * @param {string} id as the bundler has it, perhaps with a query
 */
export function isSource(project, id) {
  const path = relative(project, id.replace(/^\0/, '').replace(/\?.*$/, ''));
  return path.split(sep).includes('node_modules') || SOURCES.includes(path.split(sep)[0]);
}

async function buildPage() {
  const project = fileURLToPath(new URL('..', import.meta.url));
  const stamp = join(project, 'dist', 'editor.stamp');
  const now = fingerprint(project);
  if (existsSync(join(project, 'dist/editor/index.html')) && existsSync(stamp) && readFileSync(stamp, 'utf8') === now) return;
  rmSync(stamp, { force: true });
  const { build } = await import('vite');
  /** @type {import('vite').Plugin} */
  const watched = {
    name: 'all-sources-are-known',
    buildEnd() {
      const others = [...this.getModuleIds()].filter((id) => existsSync(id.replace(/\?.*$/, '')) && !isSource(project, id));
      if (others.length > 0) this.error(`editor/build-page.mjs: SOURCES lacks ${others.join(', ')}`);
    },
  };
  await build({ root: join(project, 'editor'), logLevel: 'warn', plugins: [watched], worker: { plugins: () => [watched] } });
  writeFileSync(stamp, now);
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) await buildPage();
