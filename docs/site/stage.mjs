import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { dirname, extname, join, posix } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { HOME } from './home.mjs';
import { PAGES } from './pages.mjs';
import { lightVersions } from './pictures.mjs';
import { referencePages } from './reference.mjs';

export const PROJECT = fileURLToPath(new URL('../..', import.meta.url));

/** Where VitePress finds the pages. */
export const STAGE = join(PROJECT, 'dist/docs-pages');

/** Where VitePress writes the site. */
export const SITE = join(PROJECT, 'dist/docs');

/** Path of the site on its server, with a slash at both ends. */
export const BASE = `/${process.env.DOCS_BASE ?? ''}/`.replace(/\/+/g, '/');

const ASKS_SYSTEM = '@media (prefers-color-scheme:dark)';

const PICTURES = ['.svg', '.png'];

/**
 * Lays out the pages for VitePress. Links keep to the site: a link to a file or folder of the source leads to its text.
 * @throws Error when a link leads nowhere, or a page of docs/ or of the project's folder is not in the sidebar
 */
export function stagePages() {
  const listed = new Map(PAGES.map(({ file, name }) => [file, `${name}.md`]));
  const written = ['', 'docs/'].flatMap((folder) => readdirSync(join(PROJECT, folder)).map((name) => `${folder}${name}`));
  const missing = written.filter((path) => path.endsWith('.md') && !listed.has(path));
  if (missing.length > 0) throw new Error(`docs/site/pages.mjs does not list ${missing.join(', ')}`);
  const absent = [...listed.keys()].filter((path) => !existsSync(join(PROJECT, path)));
  if (absent.length > 0) throw new Error(`docs/site/pages.mjs lists ${absent.join(', ')}, which do not exist`);

  rmSync(STAGE, { recursive: true, force: true });
  mkdirSync(STAGE, { recursive: true });
  const sources = new Set();
  const problems = [];

  const put = (path, text) => {
    mkdirSync(dirname(join(STAGE, path)), { recursive: true });
    writeFileSync(join(STAGE, path), text);
  };

  // files of the source are served as plain text; a folder is a page that lists its files
  const sourcePage = (path) => {
    const isFolder = statSync(join(PROJECT, path)).isDirectory();
    const target = `/source/${path}${isFolder ? '.md' : '.txt'}`;
    if (sources.has(path)) return target;
    sources.add(path);
    if (isFolder) {
      const entries = readdirSync(join(PROJECT, path)).sort();
      const links = entries.map((entry) => `- [${entry}](${sourcePage(`${path}/${entry}`)})`);
      put(target, `---\nsearch: false\noutline: false\n---\n\n# ${path}\n\n${links.join('\n')}\n`);
    } else {
      put(`public${target}`, readFileSync(join(PROJECT, path)));
    }
    return target;
  };

  const targetOf = (page, target) => {
    if (/^(https?:|mailto:|#)/.test(target)) return target;
    const [file, anchor] = target.split('#');
    const path = posix.normalize(posix.join(posix.dirname(page), file)).replace(/\/$/, '');
    const hash = anchor === undefined ? '' : `#${anchor}`;
    if (!existsSync(join(PROJECT, path))) {
      problems.push(`${page}: ${target}: no such file`);
      return target;
    }
    if (listed.has(path)) return `/${listed.get(path)}${hash}`;
    if (PICTURES.includes(extname(path))) {
      put(`pictures/${posix.basename(path)}`, readFileSync(join(PROJECT, path)));
      return `/pictures/${posix.basename(path)}`;
    }
    return sourcePage(path);
  };

  // of a picture with two versions, the theme shows the one in the colours of the page
  const light = lightVersions(PROJECT, ['docs/site/index.md', ...listed.keys()]);
  const linkOf = (page, words, target) => {
    const dark = `${words}(${targetOf(page, target)})`;
    const path = posix.join(posix.dirname(page), target);
    const name = `pictures/light-${posix.basename(path)}`;
    const svg = path.endsWith('.svg') && existsSync(join(PROJECT, path)) ? readFileSync(join(PROJECT, path), 'utf8') : '';
    if (words.startsWith('!') && svg.includes(ASKS_SYSTEM)) {
      // a chart asks the system for its colours, but the reader may choose others
      put(`pictures/${posix.basename(path)}`, svg.replaceAll(ASKS_SYSTEM, '@media all'));
      put(name, svg.replaceAll(ASKS_SYSTEM, '@media not all'));
    } else if (words.startsWith('!') && light.has(path)) put(name, light.get(path));
    else return dark;
    return `${dark}{.only-dark}${words}(/${name}){.only-light}`;
  };

  const staged = (page) => {
    let isCode = false;
    const lines = readFileSync(join(PROJECT, page), 'utf8').split('\n');
    return lines.map((line) => {
      if (/^\s*```/.test(line)) isCode = !isCode;
      // a link whose words are code is still a link: code is skipped only where it does not stand within one
      const link = /`[^`]*`(?!\])|(!?\[(?:[^\]`]|`[^`]*`)*\])\(([^)\s]+)\)/g;
      return isCode
        ? line
        : line.replace(link, (all, words, target) => (words === undefined ? all : linkOf(page, words, target)));
    });
  };

  for (const { file, name } of PAGES) put(`${name}.md`, staged(file).join('\n'));
  for (const { path, text } of referencePages()) put(`api/${path}`, text);
  put('index.md', `---\n${JSON.stringify(HOME)}\n---\n\n${staged('docs/site/index.md').join('\n')}`);
  put('public/firewalk.svg', readFileSync(join(PROJECT, 'docs/firewalk.svg')));
  put('public/light-firewalk.svg', light.get('docs/firewalk.svg'));
  put('public/icon.svg', readFileSync(join(PROJECT, 'editor/public/icon.svg')));
  if (problems.length > 0) throw new Error(problems.join('\n'));
}
