import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

/** Where `npm run reference` writes the API reference. */
const REFERENCE = fileURLToPath(new URL('../../dist/reference', import.meta.url));

/** Modules of the package, by the folders of the reference: engine, game, phaser, phaser/plugin. */
const { exports } = JSON.parse(readFileSync(new URL('../../package.json', import.meta.url), 'utf8'));
const MODULES = Object.entries(exports)
  .filter(([, { types }]) => types !== undefined)
  .map(([, { types }]) => types.replace(/^\.\/dist\/(.*?)(?:\/index)?\.d\.ts$/, '$1'))
  .sort();

/** Folders of a module, in the order of the sidebar. */
const KINDS = [
  { folder: 'functions', text: 'Functions' },
  { folder: 'classes', text: 'Classes' },
  { folder: 'interfaces', text: 'Interfaces' },
  { folder: 'type-aliases', text: 'Types' },
  { folder: 'variables', text: 'Variables' },
];

/**
 * Lists the pages of the API reference.
 * @returns {{ path: string, text: string }[]} paths in the folder of the reference, and the Markdown of each page
 * @throws Error when the reference has not been made
 */
export function referencePages() {
  if (!existsSync(REFERENCE)) throw new Error('dist/reference is missing: npm run reference makes it');
  const files = readdirSync(REFERENCE, { recursive: true }).filter((path) => path.endsWith('.md'));
  return files.map((path) => ({ path: path.replaceAll('\\', '/'), text: readFileSync(join(REFERENCE, path), 'utf8') }));
}

/**
 * Makes the sidebars of the API reference: for each module one that lists its own names only, which keeps pages small. The
 * reference has been made.
 */
export function referenceSidebars() {
  const api = { text: 'API', link: '/api/' };
  const closed = MODULES.map((module) => ({ text: module, link: `/api/${module}/` }));
  const sidebars = MODULES.map((module, i) => [`/api/${module}/`, [{ ...api, items: closed.with(i, opened(module)) }]]);
  return { '/api/': [{ ...api, items: closed }], ...Object.fromEntries(sidebars) };
}

/** A module with all its names. */
function opened(module) {
  const namesIn = (folder) => (existsSync(folder) ? readdirSync(folder) : []).map((file) => file.replace(/\.md$/, ''));
  return {
    text: module,
    link: `/api/${module}/`,
    items: KINDS.map(({ folder, text }) => ({
      text,
      collapsed: true,
      items: namesIn(join(REFERENCE, module, folder))
        .sort((a, b) => a.localeCompare(b))
        .map((name) => ({ text: name, link: `/api/${module}/${folder}/${name}` })),
    })).filter(({ items }) => items.length > 0),
  };
}
