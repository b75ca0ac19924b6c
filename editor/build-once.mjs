import { existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fingerprint } from './page-sources.mjs';

/**
 * Builds a page into a folder of dist/, unless what it is made of is the same as in the last build: that takes 10 s.
 * @param {string} project
 * @param {string} name of the folder
 * @param {readonly string[]} sources everything it is made of
 * @param {(project: string, id: string) => boolean} isSource whether a module is one of them
 * @param {(plugin: import('vite').Plugin) => import('vite').InlineConfig} configure
 */
export async function buildOnce(project, name, sources, isSource, configure) {
  const stamp = join(project, 'dist', `${name}.stamp`);
  const now = fingerprint(project, sources);
  const isThere = existsSync(join(project, 'dist', name, 'index.html')) && existsSync(stamp);
  if (isThere && readFileSync(stamp, 'utf8') === now) return;
  rmSync(stamp, { force: true });
  const { build } = await import('vite');
  await build({
    logLevel: 'warn',
    ...configure({
      name: 'sources-are-known',
      buildEnd() {
        const others = [...this.getModuleIds()].filter((id) => !isSource(project, id));
        if (others.length > 0) this.error(`editor/page-sources.mjs: the sources of ${name} lack ${others.join(', ')}`);
      },
    }),
  });
  writeFileSync(stamp, now);
}
