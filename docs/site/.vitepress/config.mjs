import { join } from 'node:path';
import { defineConfig } from 'vitepress';
import { GROUPS } from '../pages.mjs';
import { referenceSidebars } from '../reference.mjs';
import { BASE, PROJECT, SITE, STAGE } from '../stage.mjs';

// as GitHub makes anchors, so that links work there and here
const slugify = (heading) =>
  heading
    .trim()
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\s_-]/gu, '')
    .replace(/\s/g, '-');

const API = { text: 'API', link: '/api/' };

export default defineConfig({
  title: 'Gravity Quest toolkit',
  description: 'Check, solve, edit and measure levels of Gravity Quest.',
  lang: 'en',
  base: BASE,
  head: [['link', { rel: 'icon', href: `${BASE}icon.svg`, type: 'image/svg+xml' }]],
  srcDir: STAGE,
  outDir: SITE,
  cacheDir: join(PROJECT, 'node_modules/.cache/vitepress'),
  markdown: {
    theme: { light: 'github-light-high-contrast', dark: 'github-dark-high-contrast' },
    anchor: { slugify },
    config(md) {
      // Vue would take what stands in two braces for a program
      md.renderer.rules.code_inline = (tokens, index, _options, _env, self) =>
        `<code v-pre${self.renderAttrs(tokens[index])}>${md.utils.escapeHtml(tokens[index].content)}</code>`;
      const fence = md.renderer.rules.fence;
      // a page is rendered for the browser, for the server and for the search
      const rendered = new Map();
      md.renderer.rules.fence = (tokens, index, ...rest) => {
        const key = JSON.stringify([tokens[index].info, tokens[index].content]);
        if (!rendered.has(key)) rendered.set(key, render(tokens, index, ...rest));
        return rendered.get(key);
      };
      const render = (tokens, index, options, ...rest) => {
        const token = tokens[index];
        const isConsole = token.info === 'console';
        // what is printed is no program: only the lines that the reader types stand out
        if (isConsole) token.info = 'txt';
        const code = fence(tokens, index, options, ...rest);
        if (isConsole) return code.replaceAll('<span class="line"><span>$ ', '<span class="line typed"><span>$ ');
        // the name of the file that a reader makes stands above its text
        const title = /title=(\S+)/.exec(token.info)?.[1];
        return title === undefined ? code : `<p class="file-name"><code>${md.utils.escapeHtml(title)}</code></p>${code}`;
      };
    },
  },
  themeConfig: {
    search: {
      provider: 'local',
      // what is written for readers stands before the API, which names the same words on many pages
      options: { miniSearch: { searchOptions: { boostDocument: (id) => (id.includes('/api/') ? 0.2 : 1) } } },
    },
    outline: [2, 3],
    nav: [
      { text: 'Start', link: '/start' },
      { text: 'Tutorial', link: '/tutorial' },
      { text: 'Level format', link: '/level-format' },
      { text: 'Glossary', link: '/glossary' },
      { ...API, activeMatch: '^/api/' },
    ],
    sidebar: {
      ...referenceSidebars(),
      '/': GROUPS.map(({ text, pages, hasReference }) => ({
        text,
        items: [...pages.map((page) => ({ text: page.text, link: `/${page.name}` })), ...(hasReference ? [API] : [])],
      })),
    },
  },
});
