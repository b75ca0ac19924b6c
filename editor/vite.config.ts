import { defineConfig } from 'vite';
import { phaserParts } from './phaser-parts.mjs';

// a static page that runs from any folder of any host, and from `gq edit`
export default defineConfig({
  base: './',
  plugins: [phaserParts()],
  build: {
    outDir: '../dist/editor',
    emptyOutDir: true,
    // the oldest browsers that docs/editor.md promises
    target: ['chrome120', 'firefox121', 'safari17.2'],
    assetsInlineLimit: 0,
    // one file, so that the order of its rules does not depend on what is loaded first
    cssCodeSplit: false,
    // these browsers know it themselves
    modulePreload: { polyfill: false },
    // kB; what the page begins with is one file
    chunkSizeWarningLimit: 2000,
    rolldownOptions: {
      onwarn(warning, warn) {
        // `use client` directives in libraries are for server rendering, which is not used here
        if (warning.code !== 'MODULE_LEVEL_DIRECTIVE') warn(warning);
      },
    },
  },
  worker: { format: 'es' },
});
