import { build } from 'vite';

/**
 * Puts all that the page begins with into one file, and leaves the rest to what is imported later. The bundler goes by which module
 * imports which, and a face of a folder imports all of it: so a first build, without what comes later, tells what is used.
 * @param {() => import('vite').Plugin[]} others plugins that both builds need
 * @returns {import('vite').Plugin}
 */
export function firstLoad(others) {
  return {
    name: 'first-load',
    async config({ root, build: options }) {
      /** @type {Set<string>} */
      const used = new Set();
      await build({
        root,
        configFile: false,
        logLevel: 'error',
        build: { ...options, write: false, minify: false, cssMinify: false, reportCompressedSize: false },
        plugins: [
          ...others(),
          {
            name: 'without-what-comes-later',
            enforce: 'pre',
            resolveDynamicImport: () => false,
            transform: (code, id) => (id.endsWith('/workers.ts') ? code.replace(/new URL\([^)]*\)/, "''") : null),
            generateBundle(_, bundle) {
              for (const chunk of Object.values(bundle)) {
                if (chunk.type !== 'chunk') continue;
                for (const [id, { renderedLength }] of Object.entries(chunk.modules))
                  if (renderedLength > 0 || /\/index\.\w+$|\.css$/.test(id)) used.add(id);
              }
            },
          },
        ],
      });
      // the module that the page names stays a file of its own
      used.delete(`${root}/main.tsx`);
      const group = { name: 'page', test: (/** @type {string} */ id) => used.has(id), includeDependenciesRecursively: false };
      return { build: { rolldownOptions: { output: { codeSplitting: { groups: [group] } } } } };
    },
  };
}
