import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build as esbuild } from 'esbuild';
import { build as vite } from 'vite';

const PROJECT = fileURLToPath(new URL('../../..', import.meta.url));
const ENTRY = join(PROJECT, 'tests/e2e/phaser/page.mjs');

/** The packages of both majors, as node_modules names them. */
export const MAJORS = ['phaser', 'phaser3'] as const;
export type Major = (typeof MAJORS)[number];

/** Ways to get Phaser, game and runner into a page. */
export const WAYS = ['esbuild', 'Vite', 'a script tag'] as const;
export type Way = (typeof WAYS)[number];

async function bundledByEsbuild(major: Major): Promise<string> {
  const { outputFiles } = await esbuild({
    entryPoints: [ENTRY],
    bundle: true,
    format: 'esm',
    write: false,
    alias: { phaser: major },
    logLevel: 'error',
  });
  return outputFiles[0].text;
}

async function bundledByVite(major: Major): Promise<string> {
  const built = await vite({
    root: PROJECT,
    configFile: false,
    logLevel: 'error',
    resolve: { alias: [{ find: /^phaser$/, replacement: major }] },
    build: { write: false, minify: false, rolldownOptions: { input: ENTRY } },
  });
  const [{ output }] = [built].flat() as { output: { type: string; code: string }[] }[];
  return output[0].code;
}

const script = (type: string, code: string): string =>
  `<script type="${type}">${code.replaceAll('</script', '<\\/script')}</script>`;

/** The scripts of a page that set `gravityQuestTest`. */
export async function scriptsOf(way: Way, major: Major): Promise<string> {
  if (way === 'esbuild') return script('module', await bundledByEsbuild(major));
  if (way === 'Vite') return script('module', await bundledByVite(major));
  const [phaser, ours] = [`node_modules/${major}/dist/phaser.min.js`, 'dist/phaser.iife.js'].map((path) =>
    readFileSync(join(PROJECT, path), 'utf8'),
  );
  return [phaser, ours, 'globalThis.gravityQuestTest = { Phaser, ...GravityQuest };']
    .map((code) => script('text/javascript', code))
    .join('\n');
}
