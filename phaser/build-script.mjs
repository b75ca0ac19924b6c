// Builds what a script tag loads: game and runner as one classic script. It takes a moment only, so it is built every time.
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const dist = fileURLToPath(new URL('../dist', import.meta.url));

await build({
  entryPoints: [join(dist, 'phaser/global.js')],
  outfile: join(dist, 'phaser.iife.js'),
  bundle: true,
  minify: true,
  format: 'iife',
  globalName: 'GravityQuest',
  target: 'es2022',
  logLevel: 'warning',
});
