import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { join, posix } from 'node:path';

const ATTRIBUTE = /\s(href|src|id|name)="([^"]*)"/g;

const ENTITIES = { '&quot;': '"', '&#39;': "'", '&lt;': '<', '&gt;': '>', '&amp;': '&' };
const decoded = (text) => text.replace(/&(?:quot|#39|lt|gt|amp);/g, (entity) => ENTITIES[entity]);

/** Reads the tags of a page: what it links to, what it loads, the anchors that it has, and whether its text is there. */
function tagsOf(html) {
  const links = [];
  const loaded = [];
  const anchors = new Set();
  let hasText = false;
  for (const [tag, name] of html.matchAll(/<([a-z][\w-]*)\b(?:[^>"']|"[^"]*"|'[^']*')*>/g)) {
    // the sidebar has headings of the second order on every page
    hasText ||= name === 'h1';
    for (const [, attribute, value] of tag.matchAll(ATTRIBUTE)) {
      if (attribute === 'id' || (attribute === 'name' && name === 'a')) anchors.add(decoded(value));
      else if (attribute === 'href' && name === 'a') links.push(decoded(value));
      else if (attribute !== 'name') loaded.push(decoded(value));
    }
  }
  return { links, loaded, anchors, hasText };
}

/**
 * Follows every link, picture, style and script of a built site, and looks whether every page has its text.
 * @param {string} site folder of the site
 * @param {string} base path of the site on its server, with a slash at both ends
 * @returns {{ pages: number, links: number, problems: string[] }} numbers of pages and of what was followed, and what leads
 *   nowhere, is loaded from another server or is empty
 */
export function checkSite(site, base) {
  const files = readdirSync(site, { recursive: true }).map((path) => path.replaceAll('\\', '/'));
  const pages = new Map();
  const problems = [];
  for (const file of files) {
    if (file.endsWith('.html')) pages.set(file, tagsOf(readFileSync(join(site, file), 'utf8')));
    if (!file.endsWith('.css')) continue;
    const [load] = /(?:url\(\s*["']?|@import\s*["'])(?:https?:)?\/\/[^)"']*/.exec(readFileSync(join(site, file), 'utf8')) ?? [];
    if (load !== undefined) problems.push(`${file}: ${load}: loaded from another server`);
  }

  // pages share their sidebars, and so most of their links: what a path leads to is looked up once
  const found = new Map();
  const lookUp = (path) => {
    const candidates = path.endsWith('/') || path === '' ? [`${path}index.html`] : [path, `${path}.html`];
    return candidates.find((file) => existsSync(join(site, file)) && statSync(join(site, file)).isFile());
  };
  const fileOf = (path) => {
    if (!found.has(path)) found.set(path, lookUp(path));
    return found.get(path);
  };

  let links = 0;
  for (const [page, tags] of pages) {
    // VitePress goes on when a page can't be rendered, and leaves it empty
    if (!tags.hasText && page !== '404.html') problems.push(`${page}: no text: VitePress says above why it could not render it`);
    const follow = (target) => {
      links++;
      const [path, anchor = ''] = target.split('#');
      const absolute = path === '' ? `${base}${page}` : posix.resolve(posix.dirname(`${base}${page}`), path.split('?')[0]);
      const slash = path.endsWith('/') && !absolute.endsWith('/') ? '/' : '';
      if (!`${absolute}${slash}`.startsWith(base)) {
        problems.push(`${page}: ${target}: outside ${base}`);
        return;
      }
      const file = fileOf(decodeURI(`${absolute}${slash}`.slice(base.length)));
      if (file === undefined) problems.push(`${page}: ${target}: no such file`);
      else if (anchor !== '' && pages.get(file)?.anchors.has(decodeURIComponent(anchor)) === false)
        problems.push(`${page}: ${target}: no such anchor`);
    };
    for (const target of tags.links) if (!/^[a-z][a-z+.-]*:/.test(target)) follow(target);
    for (const target of tags.loaded) {
      if (/^(https?:)?\/\//.test(target)) problems.push(`${page}: ${target}: loaded from another server`);
      else if (!target.startsWith('data:')) follow(target);
    }
  }
  return { pages: pages.size, links, problems: [...new Set(problems)] };
}
