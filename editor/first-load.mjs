import { build } from 'vite';

/**
 * Puts all that the page begins with into one file, and leaves the rest to what is imported later. The bundler goes by which module
 * imports which, and a face of a folder imports all of it: so a first build, without what comes later, tells what is used. A module
 * that is used may itself need more for what comes later; further builds tell that, as the file would import it from another one,
 * which imports the file and so would find it unfinished.
 * @param {() => import('vite').Plugin[]} others plugins that both builds need
 * @returns {import('vite').Plugin}
 */
export function firstLoad(others) {
  return {
    name: 'first-load',
    async config({ root, build: options }) {
      /** @type {Set<string>} */
      const used = new Set();
      const group = { name: 'page', test: (/** @type {string} */ id) => used.has(id), includeDependenciesRecursively: false };
      const output = { codeSplitting: { groups: [group] } };
      // the module that the page names stays a file of its own
      const main = `${root}/main.tsx`;
      const withoutWorkers = {
        name: 'without-workers',
        enforce: /** @type {const} */ ('pre'),
        transform: (/** @type {string} */ code, /** @type {string} */ id) =>
          id.endsWith('/workers.ts') ? code.replace(/new URL\([^)]*\)/, "''") : null,
      };
      /** @param {import('vite').Plugin[]} plugins @param {typeof output | null} split */
      const chunksOf = async (plugins, split) => {
        const made = await build({
          root,
          configFile: false,
          logLevel: 'error',
          build: {
            ...options,
            ...{ write: false, minify: false, cssMinify: false, reportCompressedSize: false },
            rolldownOptions: split === null ? {} : { output: split },
          },
          plugins: [...others(), withoutWorkers, ...plugins],
        });
        const parts = [made].flat().flatMap((one) => ('output' in one ? one.output : []));
        return parts.flatMap((part) => (part.type === 'chunk' ? part : []));
      };

      const withoutLater = { name: 'without-what-comes-later', resolveDynamicImport: () => /** @type {const} */ (false) };
      for (const { modules } of await chunksOf([withoutLater], null))
        for (const [id, { renderedLength }] of Object.entries(modules))
          if (renderedLength > 0 || /\/index\.\w+$|\.css$/.test(id)) used.add(id);
      used.delete(main);
      for (let known = -1; known < used.size; ) {
        known = used.size;
        const chunks = await chunksOf([], output);
        const page = chunks.find(({ name }) => name === 'page');
        for (const { fileName, modules } of chunks)
          if (page?.imports.includes(fileName)) for (const id of Object.keys(modules)) if (!id.startsWith('\0')) used.add(id);
        used.delete(main);
      }
      return { build: { rolldownOptions: { output } } };
    },
  };
}
