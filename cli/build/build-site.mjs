// Builds the game that `gq build` puts beside a pack, unless what it is made of is the same as in the last build.
import { existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { fingerprint, isSiteSource, SITE_SOURCES } from '../../editor/page-sources.mjs';

const project = fileURLToPath(new URL('../..', import.meta.url));
const site = join(project, 'dist', 'site');
const stamp = join(project, 'dist', 'site.stamp');
const now = fingerprint(project, SITE_SOURCES);

function isBuilt() {
  return existsSync(join(site, 'index.html')) && existsSync(stamp) && readFileSync(stamp, 'utf8') === now;
}

/** @type {import('vite').Plugin} */
const sourcesAreKnown = {
  name: 'sources-are-known',
  buildEnd() {
    const others = [...this.getModuleIds()].filter((id) => !isSiteSource(project, id));
    if (others.length > 0) this.error(`editor/page-sources.mjs: SITE_SOURCES lacks ${others.join(', ')}`);
  },
};

if (!isBuilt()) {
  rmSync(stamp, { force: true });
  // the shipped levels, whatever somebody plays in the example
  delete process.env.LEVELS;
  delete process.env.TITLE;
  const { build } = await import('vite');
  await build({
    root: join(project, 'examples', 'phaser'),
    logLevel: 'warn',
    plugins: [sourcesAreKnown],
    build: { outDir: site, emptyOutDir: true },
  });
  writeFileSync(stamp, now);
}
