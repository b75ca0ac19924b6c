// Bundles the command line into dist/gq: finding and loading some 500 modules takes Node longer than most checks take. The bundle is
// made in a moment, so it is made every time. The packages that it needs stay packages, and comments stay in dist/cli.
import { chmodSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { basename, dirname, isAbsolute, join, relative, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'rolldown';

const PROJECT = fileURLToPath(new URL('..', import.meta.url));
const CLI = join(PROJECT, 'dist/cli');
const BUNDLE = join(PROJECT, 'dist/gq');

/** The way from dist/cli to a built module, as URLs have it. */
const wayTo = (path) => relative(CLI, path).split(sep).join('/');

const isWorker = (path) => basename(path) === 'worker.js';

/** What a module with which something starts is called in the bundle: `check/worker.js` is `check-worker`. */
const nameInBundle = (path) => wayTo(path).replaceAll('/', '-').replace(/\.js$/, '');

const OWN_PLACE = /new URL\('\.\/worker\.js', import\.meta\.url\)|import\.meta\.url/g;

/** Lets modules that ask where they are find the worker beside them, and all else as if dist/gq were dist/cli. */
const places = {
  name: 'places',
  transform(code, path) {
    if (!path.startsWith(CLI + sep)) return null;
    const worker = nameInBundle(join(dirname(path), 'worker.js'));
    return code.replace(OWN_PLACE, (found) =>
      found.startsWith('new')
        ? `new URL('./${worker}.js', import.meta.url)`
        : `new URL('./${wayTo(path)}', import.meta.url).href`,
    );
  },
};

// with the command line, for processes that run several commands
const entries = ['main.js', 'command-line.js', ...readdirSync(CLI, { recursive: true }).filter(isWorker)];

const { output } = await build({
  input: Object.fromEntries(entries.sort().map((path) => [nameInBundle(join(CLI, path)), join(CLI, path)])),
  // paths in comments begin there, so that every clone makes the same bytes
  cwd: PROJECT,
  platform: 'node',
  external: (id) => !id.startsWith('.') && !isAbsolute(id),
  plugins: [places],
  output: { dir: BUNDLE, format: 'esm', entryFileNames: '[name].js', chunkFileNames: '[name]-[hash].js', comments: false },
  write: false,
});

// a command that runs meanwhile still finds what has not changed
mkdirSync(BUNDLE, { recursive: true });
const made = new Map(output.map(({ fileName, code }) => [fileName, code]));
for (const name of readdirSync(BUNDLE)) if (!made.has(name)) rmSync(join(BUNDLE, name));
for (const [name, code] of made) {
  const path = join(BUNDLE, name);
  if (!existsSync(path) || readFileSync(path, 'utf8') !== code) writeFileSync(path, code);
}
chmodSync(join(BUNDLE, 'main.js'), 0o755);
// npx keeps links to the commands of a folder, also to where they were before
chmodSync(join(BUNDLE, '../cli/main.js'), 0o755);
