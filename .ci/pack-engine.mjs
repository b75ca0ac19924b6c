import { execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { builtinModules } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join, relative, resolve } from 'node:path';
import process from 'node:process';

// node .ci/pack-engine.mjs [FOLDER]
// Packs gravity-quest-engine: the modules that a game needs, without the command line, the editor and what they depend on. It has
// the files of the toolkit's build that the entries below reach, and depends on the packages that those files import. Nothing
// is listed by hand, so the two packages can't differ.

const PROJECT = resolve(import.meta.dirname, '..');

export const ENGINE_NAME = 'gravity-quest-engine';

/** Modules of the toolkit that a game does not need. They read and write what people write, and so need zod. */
const OTHERS = ['./schema', './solver'];

/** The entries of the toolkit that the engine's package has, too, under its own name. */
export const ENGINE_ENTRIES = Object.entries(JSON.parse(readFileSync(join(PROJECT, 'package.json'), 'utf8')).exports)
  .filter(([entry, target]) => target.types !== undefined && !OTHERS.includes(entry))
  .map(([entry]) => entry);

/** Fields of the manifest that both packages share. */
const SHARED = ['version', 'license', 'type', 'engines', 'sideEffects', 'author', 'homepage', 'bugs', 'repository'];

const IMPORTED = /^\s*(?:import|export)\s[^;]*?\bfrom\s+'([^']+)'|^\s*import\s+'([^']+)'|\bimport\('([^']+)'\)/gm;

/**
 * The files that entries reach by relative imports, and the packages that those import.
 * @param {readonly string[]} entries paths of modules and declarations
 * @returns {{ files: Set<string>, packages: Set<string> }} absolute paths; names of packages
 * @throws Error when an import leads nowhere
 */
export function reach(entries) {
  const files = new Set();
  const packages = new Set();
  const open = entries.map((entry) => resolve(entry));
  for (let file = open.pop(); file !== undefined; file = open.pop()) {
    if (files.has(file)) continue;
    files.add(file);
    for (const [, from, bare, dynamic] of readFileSync(file, 'utf8').matchAll(IMPORTED)) {
      const target = from ?? bare ?? dynamic;
      if (!target.startsWith('.')) {
        if (builtinModules.includes(target.replace(/^node:/, '')))
          throw new Error(`${file} imports ${target}: the engine must run without Node`);
        packages.add(/^(@[^/]+\/)?[^/]+/.exec(target)[0]);
        continue;
      }
      const path = join(dirname(file), target);
      const found = file.endsWith('.d.ts') ? path.replace(/\.(?:ts|js)$/, '.d.ts') : path;
      if (!existsSync(found)) throw new Error(`${relative(PROJECT, file)} imports ${target}, which is not built: npm run build`);
      open.push(found);
    }
  }
  return { files, packages };
}

/** The part of a record with the named keys, or nothing if that is empty. */
function part(record, names) {
  const entries = Object.entries(record ?? {}).filter(([name]) => names.has(name));
  return entries.length > 0 ? Object.fromEntries(entries) : undefined;
}

/**
 * The manifest of the engine's package.
 * @param toolkit that of the toolkit
 * @param {Set<string>} packages what the engine's files import
 */
export function engineManifest(toolkit, packages) {
  const known = new Set([...Object.keys(toolkit.dependencies), ...Object.keys(toolkit.peerDependencies ?? {})]);
  const unknown = [...packages].filter((name) => !known.has(name));
  if (unknown.length > 0)
    throw new Error(`the engine imports ${unknown.join(', ')}, which package.json does not list as a dependency`);
  return {
    name: ENGINE_NAME,
    ...part(toolkit, new Set(SHARED)),
    description: 'Physics engine of Gravity Quest, and what a game needs around it: a player, plays, a runner for Phaser.',
    exports: { ...part(toolkit.exports, new Set(ENGINE_ENTRIES)), './package.json': './package.json' },
    files: ['dist'],
    dependencies: part(toolkit.dependencies, packages),
    peerDependencies: part(toolkit.peerDependencies, packages),
    peerDependenciesMeta: part(toolkit.peerDependenciesMeta, packages),
  };
}

/**
 * Packs the built engine.
 * @param {string} folder where the tarball is written
 * @returns {string} its path
 */
export function packEngine(folder) {
  const toolkit = JSON.parse(readFileSync(join(PROJECT, 'package.json'), 'utf8'));
  const conditions = ENGINE_ENTRIES.map((entry) => toolkit.exports[entry]);
  const { files, packages } = reach(conditions.flatMap((c) => [c.types, c.default]).map((path) => join(PROJECT, path)));
  const manifest = engineManifest(toolkit, packages);
  const stage = mkdtempSync(join(tmpdir(), 'gq-engine-'));
  try {
    for (const file of files) {
      const copy = join(stage, relative(PROJECT, file));
      mkdirSync(dirname(copy), { recursive: true });
      // the package has no source maps
      writeFileSync(copy, readFileSync(file, 'utf8').replace(/^\/\/# sourceMappingURL=.*\n?/m, ''));
    }
    copyFileSync(join(PROJECT, 'LICENSE'), join(stage, 'LICENSE'));
    copyFileSync(join(PROJECT, '.ci/engine-readme.md'), join(stage, 'README.md'));
    writeFileSync(join(stage, 'package.json'), `${JSON.stringify(manifest, null, 2)}\n`);
    execFileSync('npm', ['pack', '--silent', '--pack-destination', folder], {
      cwd: stage,
      stdio: ['ignore', 'ignore', 'inherit'],
    });
  } finally {
    rmSync(stage, { recursive: true, force: true });
  }
  return join(folder, `${ENGINE_NAME}-${manifest.version}.tgz`);
}

if (process.argv[1] === import.meta.filename) console.log(packEngine(resolve(process.argv[2] ?? '.')));
