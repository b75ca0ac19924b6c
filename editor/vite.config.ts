import { defineConfig } from 'vite';

// a static page that runs from any folder of any host, and from `gq edit`
export default defineConfig({
  base: './',
  build: {
    outDir: '../dist/editor',
    emptyOutDir: true,
    // the oldest browsers that docs/editor.md promises
    target: ['chrome120', 'firefox121', 'safari17.2'],
    assetsInlineLimit: 0,
    // kB; Phaser alone exceeds the default limit
    chunkSizeWarningLimit: 2800,
    rolldownOptions: {
      onwarn(warning, warn) {
        // `use client` directives in libraries are for server rendering, which is not used here
        if (warning.code !== 'MODULE_LEVEL_DIRECTIVE') warn(warning);
      },
    },
  },
  worker: { format: 'es' },
});
