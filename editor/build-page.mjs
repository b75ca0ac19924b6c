// Builds the page, unless what it is made of is the same as in the last build: that takes 10 s.
import { cpSync, existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { fingerprint, isSource } from './page-sources.mjs';

const project = fileURLToPath(new URL('..', import.meta.url));
const stamp = join(project, 'dist', 'editor.stamp');
const now = fingerprint(project);

function isBuilt() {
  return existsSync(join(project, 'dist/editor/index.html')) && existsSync(stamp) && readFileSync(stamp, 'utf8') === now;
}

/** @type {import('vite').Plugin} */
const sourcesAreKnown = {
  name: 'sources-are-known',
  buildEnd() {
    const others = [...this.getModuleIds()].filter((id) => !isSource(project, id));
    if (others.length > 0) this.error(`editor/page-sources.mjs: SOURCES lacks ${others.join(', ')}`);
  },
};

if (!isBuilt()) {
  rmSync(stamp, { force: true });
  const { build } = await import('vite');
  const plugins = [sourcesAreKnown];
  await build({ root: join(project, 'editor'), logLevel: 'warn', plugins, worker: { plugins: () => plugins } });
  writeFileSync(stamp, now);
}

// the game, which the page puts into what it publishes
const game = join(project, 'dist/editor/game');
const gameNow = readFileSync(join(project, 'dist/site.stamp'), 'utf8');
const gameStamp = join(project, 'dist/editor-game.stamp');
if (!existsSync(game) || !existsSync(gameStamp) || readFileSync(gameStamp, 'utf8') !== gameNow) {
  rmSync(game, { recursive: true, force: true });
  cpSync(join(project, 'dist/site'), game, { recursive: true });
  writeFileSync(gameStamp, gameNow);
}
