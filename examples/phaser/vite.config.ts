import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { basename, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';

const here = fileURLToPath(new URL('./', import.meta.url));
const NAME = 'gravity-quest-toolkit';
const LEVEL_FILE = '.level.json';

/** The folder of the toolkit: the checkout that this example is part of, or what npm has installed. */
function findToolkit(): string {
  const places = [resolve(here, '../..'), join(here, 'node_modules', NAME)];
  const isToolkit = (folder: string) => {
    const manifest = join(folder, 'package.json');
    return existsSync(manifest) && JSON.parse(readFileSync(manifest, 'utf8')).name === NAME;
  };
  const found = places.find(isToolkit);
  if (found === undefined) throw new Error(`expected ${NAME} in one of ${places.join(', ')}; run npm install`);
  return found;
}

const toolkit = findToolkit();
/** The folder of levels that is played. LEVELS names another one: `LEVELS=../my-levels npm run dev`. */
const levels = resolve(process.env.LEVELS ?? join(toolkit, 'levels'));

/** pack.js: a classic script that works from `file://`, where a page may not fetch anything. */
function packScript(): string {
  const files = readdirSync(levels)
    .filter((name) => name.endsWith(LEVEL_FILE))
    .sort();
  if (files.length === 0) throw new Error(`expected files that end with ${LEVEL_FILE} in ${levels}, found none`);
  const pack = {
    title: process.env.TITLE ?? (process.env.LEVELS === undefined ? 'Gravity Quest' : basename(levels)),
    levels: files.map((name) => ({
      id: name.slice(0, -LEVEL_FILE.length),
      level: JSON.parse(readFileSync(join(levels, name), 'utf8')),
    })),
  };
  return `globalThis.GRAVITY_QUEST_PACK = ${JSON.stringify(pack)};\n`;
}

/** Serves and writes pack.js. While developing, the page reloads when a level file changes. */
const pack: Plugin = {
  name: 'pack',
  configureServer(server) {
    server.middlewares.use((request, response, next) => {
      if (request.url?.split('?')[0] !== '/pack.js') return next();
      try {
        const script = packScript();
        response.setHeader('Content-Type', 'text/javascript').end(script);
      } catch (error) {
        next(error);
      }
    });
    server.watcher.add(levels);
    const reload = (path: string) => {
      if (path.startsWith(levels) && path.endsWith(LEVEL_FILE)) server.ws.send({ type: 'full-reload' });
    };
    server.watcher.on('add', reload).on('change', reload).on('unlink', reload);
  },
  generateBundle() {
    this.emitFile({ type: 'asset', fileName: 'pack.js', source: packScript() });
  },
};

/** Makes the built page work from `file://`, where browsers load no modules: the one script becomes a classic one. */
const classicScript: Plugin = {
  name: 'classic-script',
  apply: 'build',
  transformIndexHtml: {
    order: 'post',
    handler: (html) => html.replace('<script type="module" crossorigin ', '<script defer '),
  },
};

export default defineConfig({
  root: here,
  base: './',
  resolve: {
    alias: [{ find: new RegExp(`^${NAME}/(\\w+)$`), replacement: join(toolkit, 'dist/$1/index.js') }],
  },
  // pack.js stands beside the bundle, so that another pack needs no build
  plugins: [pack, classicScript],
  build: {
    target: ['chrome120', 'firefox121', 'safari17.2'],
    emptyOutDir: true,
    modulePreload: false,
    // kB; Phaser is most of it
    chunkSizeWarningLimit: 2000,
    rolldownOptions: {
      output: { format: 'iife', entryFileNames: 'game.js' },
      checks: { pluginTimings: false },
    },
  },
});
