import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, relative, sep } from 'node:path';
import process from 'node:process';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { reasonAgainst } from '../.ci/before-publish.mjs';
import { lineOf, versionProblems } from '../.ci/check-version.mjs';
import { ENGINE_ENTRIES, engineManifest, reach } from '../.ci/pack-engine.mjs';
import { ENGINE_ID } from '../game/index.ts';

const root = dirname(import.meta.dirname);
const manifest = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));

/** The targets of links and pictures in a Markdown text, without those of other hosts and without anchors. */
const relativeLinks = (text: string): string[] =>
  [...text.replace(/^```.*?^```/gms, '').matchAll(/\]\(([^)\s]+)\)/g)]
    .map(([, target]) => target.replace(/#.*$/, ''))
    .filter((target) => target !== '' && !/^[a-z]+:/i.test(target));

// npm is a script of cmd.exe there
describe.runIf(process.platform !== 'win32')('the package', () => {
  let folder: string;
  const packed = () => join(folder, 'package');
  beforeAll(() => {
    folder = mkdtempSync(join(tmpdir(), 'gq-package-'));
    execFileSync('npm', ['pack', '--ignore-scripts', '--pack-destination', folder], { cwd: root, stdio: 'ignore' });
    execFileSync('tar', ['-xzf', `${manifest.name}-${manifest.version}.tgz`], { cwd: folder });
  });
  afterAll(() => rmSync(folder, { recursive: true, force: true }));

  it('contains everything to which its README links', () => {
    const links = relativeLinks(readFileSync(join(packed(), 'README.md'), 'utf8'));
    expect(links.length).toBeGreaterThan(10);
    expect(links.filter((link) => !existsSync(join(packed(), link)))).toEqual([]);
  });

  it('contains no source map, since it does not contain the sources', () => {
    const files = execFileSync('tar', ['-tzf', `${manifest.name}-${manifest.version}.tgz`], { cwd: folder, encoding: 'utf8' });
    expect(files).toContain('package/dist/gq/main.js\n');
    expect(files.split('\n').filter((file) => /\.map$|\.ts$/.test(file) && !file.endsWith('.d.ts'))).toEqual([]);
  });

  it('has the command under its own name as well, which nobody else can have where the package is not installed', () => {
    expect(Object.keys(manifest.bin)).toEqual(['gq', manifest.name]);
    for (const file of Object.values<string>(manifest.bin)) expect(existsSync(join(packed(), file))).toBe(true);
  });
});

describe('the package of the engine alone', () => {
  const entries = ENGINE_ENTRIES.flatMap((entry) => Object.values<string>(manifest.exports[entry])).map((path) =>
    join(root, path),
  );
  const { files, packages } = reach(entries);

  it('needs two packages, and Phaser for its types: no zod, which engine, game and phaser avoid by schema/basics', () => {
    expect([...packages].sort()).toEqual(['@noble/hashes', 'flatbush', 'phaser']);
    const made = engineManifest(manifest, packages);
    expect(Object.keys(made.dependencies ?? {}).sort()).toEqual(['@noble/hashes', 'flatbush']);
    expect(made).toMatchObject({
      version: manifest.version,
      peerDependencies: { phaser: manifest.peerDependencies.phaser },
      peerDependenciesMeta: { phaser: { optional: true } },
    });
  });

  it('has modules of schema, engine, game and phaser alone, each with its declarations', () => {
    const rooms = new Set([...files].map((file) => relative(join(root, 'dist'), file).split(sep)[0]));
    expect([...rooms].sort()).toEqual(['engine', 'game', 'phaser', 'schema']);
    expect([...files].filter((file) => file.endsWith('.d.ts')).length).toBeGreaterThan(50);
  });

  it('is refused when a module imports a package that is no dependency, or a module of Node', () => {
    expect(() => engineManifest(manifest, new Set(['left-pad']))).toThrow(/imports left-pad, which package\.json does not list/);
    expect(() => reach([join(root, 'dist/cli/terminal/messages.js'), join(root, 'dist/cli/io/write.js')])).toThrow(
      /imports node:/,
    );
    expect(() => reach([join(root, 'dist/engine/index.js').replace('index', 'missing')])).toThrow();
  });

  it('is read by TypeScript before 5.7, which has no typed arrays with a type argument', () => {
    const generic = [...files].filter(
      (file) => file.endsWith('.d.ts') && /\b(?:Float64|Int32|Uint8|Uint32)Array</.test(readFileSync(file, 'utf8')),
    );
    expect(generic).toEqual([]);
  });
});

describe('what an old build has left', () => {
  it('is removed before the package is packed, and no other module', () => {
    // in a project of its own: others may be packing this one
    const project = mkdtempSync(join(tmpdir(), 'gq-stale-'));
    const words = join(project, 'dist/check/words');
    mkdirSync(words, { recursive: true });
    mkdirSync(join(project, 'check/words'), { recursive: true });
    writeFileSync(join(project, 'check/words/figures.ts'), '');
    const ends = ['.js', '.js.map', '.d.ts'];
    for (const name of ['figures', 'gone']) for (const end of ends) writeFileSync(join(words, `${name}${end}`), '');
    execFileSync(process.execPath, ['.ci/remove-stale.mjs', project], { cwd: root });
    const exist = (name: string) => ends.map((end) => existsSync(join(words, `${name}${end}`)));
    expect(exist('gone')).toEqual([false, false, false]);
    expect(exist('figures')).toEqual([true, true, true]);
    rmSync(project, { recursive: true });
  });
});

describe('publishing', () => {
  it('is refused without the address of the repository', () => {
    expect(reasonAgainst({})).toMatch(/no "repository"/);
    expect(reasonAgainst({ repository: { type: 'git' } })).toMatch(/no "repository"/);
    expect(reasonAgainst({ repository: { type: 'git', url: 'git+https://example.org/a.git' } })).toBeNull();
    expect(reasonAgainst({ repository: 'github:a/b' })).toBeNull();
    const ended = spawnSync(process.execPath, [join(root, '.ci/before-publish.mjs')], { encoding: 'utf8' });
    expect(ended.status).toBe(reasonAgainst(manifest) === null ? 0 : 1);
  });
});

describe('the version', () => {
  const results = JSON.parse(readFileSync(join(root, '.ci/results.json'), 'utf8'));
  const changelog = readFileSync(join(root, 'CHANGELOG.md'), 'utf8');
  const here = { version: manifest.version, identity: ENGINE_ID, results, changelog };
  const other = ENGINE_ID.replace(/^./, (digit) => (digit === 'f' ? '0' : 'f'));

  it('allows the results of runs that the engine has', () => {
    expect(versionProblems(here)).toEqual([]);
  });

  it.each([
    ['0.1.0', '0.1'],
    ['0.12.3', '0.12'],
    ['1.4.0', '1'],
    ['12.0.1', '12'],
  ])('%s belongs to the line %s, within which results stay the same', (version, line) => {
    expect(lineOf(version)).toBe(line);
  });

  it('must be another line when results change', () => {
    expect(versionProblems({ ...here, identity: other })).toEqual([
      expect.stringMatching(/results of runs have changed: .*0\.2\.0/),
    ]);
    const major = { ...here, version: '3.1.4', changelog: '\n## [3.0.0]', results: { 3: ENGINE_ID } };
    expect(versionProblems(major)).toEqual([]);
    expect(versionProblems({ ...major, identity: other })).toEqual([expect.stringContaining('version 4.0 in package.json')]);
  });

  it('needs its line in the table, and in the changelog', () => {
    expect(versionProblems({ ...here, version: '7.0.0' })).toEqual([expect.stringContaining(`add "7": "${ENGINE_ID}"`)]);
    const two = { ...results, 0.2: other };
    expect(versionProblems({ ...here, results: two })).toEqual([expect.stringMatching(/CHANGELOG\.md has no heading for 0\.2/)]);
    expect(versionProblems({ ...here, results: { ...results, 0.2: ENGINE_ID }, changelog: '\n## [0.1.0]\n## [0.2.0]' })).toEqual([
      expect.stringContaining('results did not change'),
    ]);
  });

  it('is the one of which docs/versioning.md speaks', () => {
    expect(readFileSync(join(root, 'docs/versioning.md'), 'utf8')).toContain('`.ci/results.json`');
  });
});
