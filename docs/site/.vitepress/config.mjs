import { existsSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { defineConfig } from 'vitepress';
import { GROUPS } from '../pages.mjs';
import { PROJECT, STAGE } from '../stage.mjs';

// as GitHub makes anchors, so that links work there and here
const slugify = (heading) =>
  heading
    .trim()
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\s_-]/gu, '')
    .replace(/\s/g, '-');

const hasReference = existsSync(join(PROJECT, 'dist/api'));
const reference = { text: 'API', link: '/api/index.html', target: '_self' };

const base = process.env.DOCS_BASE ?? '/';

export default defineConfig({
  title: 'Gravity Quest toolkit',
  description: 'Check, solve, edit and measure levels of Gravity Quest.',
  lang: 'en',
  base,
  head: [['link', { rel: 'icon', href: `${base}icon.svg`, type: 'image/svg+xml' }]],
  srcDir: STAGE,
  outDir: join(PROJECT, 'dist/docs'),
  cacheDir: join(PROJECT, 'node_modules/.cache/vitepress'),
  // a link that leads nowhere fails the build
  ignoreDeadLinks: [/^\/api\//],
  markdown: {
    anchor: { slugify },
    config(md) {
      const fence = md.renderer.rules.fence;
      md.renderer.rules.fence = (tokens, index, options, ...rest) => {
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
    search: { provider: 'local' },
    outline: [2, 3],
    nav: [
      { text: 'Start', link: '/start' },
      { text: 'Tutorial', link: '/tutorial' },
      { text: 'Level format', link: '/level-format' },
      { text: 'Glossary', link: '/glossary' },
      ...(hasReference ? [reference] : []),
    ],
    sidebar: GROUPS.map(({ text, pages }) => ({
      text,
      items: [
        ...pages.map((page) => ({ text: page.text, link: `/${page.name}` })),
        ...(hasReference && text === 'How it works' ? [reference] : []),
      ],
    })),
  },
});
