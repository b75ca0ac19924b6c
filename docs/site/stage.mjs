import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { dirname, extname, join, posix } from 'node:path';
import { fileURLToPath } from 'node:url';
import { HOME } from './home.mjs';
import { PAGES } from './pages.mjs';

export const PROJECT = fileURLToPath(new URL('../..', import.meta.url));

/** Where VitePress finds the pages. */
export const STAGE = join(PROJECT, 'dist/docs-pages');

const PICTURES = ['.svg', '.png'];

/**
 * Lays out the pages for VitePress. Links keep to the site: a link to a file or folder of the source leads to its text.
 * @throws Error when a link leads nowhere, or a page of docs/ is not in the sidebar
 */
export function stagePages() {
  const listed = new Map(PAGES.map(({ file, name }) => [file, `${name}.md`]));
  const missing = readdirSync(join(PROJECT, 'docs')).filter((name) => name.endsWith('.md') && !listed.has(`docs/${name}`));
  if (missing.length > 0) throw new Error(`docs/site/pages.mjs does not list ${missing.join(', ')}`);

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

  const staged = (page) => {
    let isCode = false;
    const lines = readFileSync(join(PROJECT, page), 'utf8').split('\n');
    return lines.map((line) => {
      if (/^\s*```/.test(line)) isCode = !isCode;
      // a link whose words are code is still a link: code is skipped only where it does not stand within one
      const link = /`[^`]*`(?!\])|(!?\[(?:[^\]`]|`[^`]*`)*\])\(([^)\s]+)\)/g;
      return isCode
        ? line
        : line.replace(link, (all, words, target) => (words === undefined ? all : `${words}(${targetOf(page, target)})`));
    });
  };

  for (const { file, name } of PAGES) put(`${name}.md`, staged(file).join('\n'));
  put('index.md', `---\n${JSON.stringify(HOME)}\n---\n\n${staged('docs/site/index.md').join('\n')}`);
  put('public/firewalk.svg', readFileSync(join(PROJECT, 'docs/firewalk.svg')));
  put('public/icon.svg', readFileSync(join(PROJECT, 'editor/public/icon.svg')));
  if (problems.length > 0) throw new Error(problems.join('\n'));
}
