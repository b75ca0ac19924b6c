// Builds the game that `gq build` puts beside a pack.
import { join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { buildOnce } from '../../editor/build-once.mjs';
import { isSiteSource, SITE_SOURCES } from '../../editor/page-sources.mjs';

const project = fileURLToPath(new URL('../..', import.meta.url));

// the shipped levels, whatever somebody plays in the example
delete process.env.LEVELS;
delete process.env.TITLE;

await buildOnce(project, 'site', SITE_SOURCES, isSiteSource, (plugin) => ({
  root: join(project, 'examples', 'phaser'),
  plugins: [plugin],
  build: { outDir: join(project, 'dist', 'site'), emptyOutDir: true },
}));
