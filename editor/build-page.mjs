// Builds the editor's page.
import { cpSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildOnce } from './build-once.mjs';
import { firstLoad } from './first-load.mjs';
import { isSource, SOURCES } from './page-sources.mjs';
import { phaserParts } from './phaser-parts.mjs';

const project = fileURLToPath(new URL('..', import.meta.url));

await buildOnce(project, 'editor', SOURCES, isSource, (plugin) => ({
  root: join(project, 'editor'),
  plugins: [plugin, firstLoad(() => [phaserParts()])],
  worker: { plugins: () => [plugin] },
}));

// the game, which the page puts into what it publishes
const game = join(project, 'dist/editor/game');
rmSync(game, { recursive: true, force: true });
cpSync(join(project, 'dist/site'), game, { recursive: true });
