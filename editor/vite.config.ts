import { defineConfig } from 'vite';

// a static page: it runs from any folder of any host, and from `gq edit`
export default defineConfig({
  base: './',
  build: {
    outDir: '../dist/editor',
    emptyOutDir: true,
    target: 'es2023',
    assetsInlineLimit: 0,
    // kB: Phaser alone has more than the usual limit
    chunkSizeWarningLimit: 2600,
    rolldownOptions: {
      onwarn(warning, warn) {
        // `use client` in a library speaks to servers that render; there is none
        if (warning.code !== 'MODULE_LEVEL_DIRECTIVE') warn(warning);
      },
    },
  },
  worker: { format: 'es' },
});
