import { execFileSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join, relative, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { circlesIn, importGraph, passedFaces } from './architecture/import-graph.ts';
import { importProblems, importsOf, purityProblems } from './architecture/inspect-source.ts';
import { machineWords } from './architecture/machine-words.ts';
import { ROOMS } from './architecture/rooms.ts';

const root = dirname(dirname(fileURLToPath(import.meta.url)));
const manifest = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
const runtime = Object.keys({ ...manifest.dependencies, ...manifest.optionalDependencies });
const bundled = [...runtime, ...Object.keys(manifest.devDependencies)];

const NOT_OURS = new Set(['node_modules', 'dist', '.git', 'coverage']);

function filesUnder(folder: string): string[] {
  if (!existsSync(folder)) return [];
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    if (NOT_OURS.has(entry.name)) return [];
    const path = join(folder, entry.name);
    return entry.isDirectory() ? filesUnder(path) : entry.isFile() ? [path] : [];
  });
}

const fromRoot = (path: string) => relative(root, path).split(sep).join('/');
const sourcesOf = (room: string) =>
  filesUnder(join(root, room))
    .filter((path) => /\.tsx?$/.test(path))
    .map((path) => ({ path: fromRoot(path), text: readFileSync(path, 'utf8') }));

describe.each(Object.entries(ROOMS).filter(([name]) => existsSync(join(root, name))))('room %s', (name, room) => {
  const sources = sourcesOf(name);

  it('imports only allowed rooms, through the index files of folders', () => {
    expect(sources.length).toBeGreaterThan(0);
    expect(sources.flatMap(({ path, text }) => importProblems(path, text, room.bundled ? bundled : runtime))).toEqual([]);
  });

  if (room.pure) {
    it('is pure, and its arithmetic is the same in every engine', () => {
      expect(sources.flatMap(({ path, text }) => purityProblems(path, text))).toEqual([]);
    });
  }

  it('has a tsconfig with which the compiler enforces the same limits', () => {
    const config = JSON.parse(readFileSync(join(root, name, 'tsconfig.json'), 'utf8'));
    const references = config.references.map((r: { path: string }) => r.path.replace('../', ''));
    expect(references.filter((r: string) => !room.knows.includes(r))).toEqual([]);
    if (room.pure) expect(config.compilerOptions.types).toEqual([]);
    if (room.pure) expect(config.compilerOptions.lib ?? ['es2023']).toEqual(['es2023']);
  });
});

describe('the example', () => {
  it('imports only what the package publishes, Phaser, and its own files', () => {
    const sources = sourcesOf('examples/phaser/src');
    expect(sources.length).toBeGreaterThan(10);
    const published = Object.keys(manifest.exports).map((entry) => entry.replace('.', 'gravity-quest-toolkit'));
    const others = sources.flatMap(({ path, text }) =>
      importsOf(path, text)
        .filter(
          (name) => name === null || !(published.includes(name) || name === 'phaser' || /^\.\/[\w-]+\.(ts|css)$/.test(name)),
        )
        .map((name) => `${path}: ${name}`),
    );
    expect(others).toEqual([]);
  });
});

describe('imports of files', () => {
  it('have no cycles, and never bypass the index file of a folder', () => {
    const graph = importGraph([...Object.keys(ROOMS), 'bench', 'tests'].flatMap(sourcesOf));
    const inRooms = new Map([...graph].filter(([path]) => path.split('/')[0] in ROOMS));
    expect(graph.size).toBeGreaterThan(500);
    expect([...circlesIn(graph), ...passedFaces(inRooms)]).toEqual([]);
  });
});

describe('rules are read from the level', () => {
  // the names that a file uses, without comments
  const usersOf = (names: RegExp, rooms: readonly string[]) =>
    rooms
      .flatMap(sourcesOf)
      .filter(({ text }) => names.test(text.replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, '')))
      .map(({ path }) => path)
      .sort();
  const rooms = Object.keys(ROOMS);

  it('the rules of the original game are only used where there is no level', () => {
    const allowed = {
      'engine/contact.ts': 'defines the box of the game’s own rules',
      'engine/index.ts': 'passes it on',
      'game/play/level-hash.ts': 'leaves out the rules of a level that are the game’s own',
      'schema/basics/default-rules.ts': 'defines them',
      'schema/basics/index.ts': 'passes them on',
      'schema/index.ts': 'passes them on',
      'schema/level/resolve.ts': 'takes the rules of a folder into a level that leaves it',
      'schema/level/rules.ts': 'has them in the table of rules',
    };
    expect(usersOf(/\bDEFAULT_(RULES|BOX)\b/, rooms)).toEqual(Object.keys(allowed));
  });
});

describe('terms are a value', () => {
  /** Files outside of the engine that may name a limit or an accuracy that holds where nothing is said, and why. */
  const ALLOWED: Readonly<Record<string, string>> = {
    'cli/options/terms.ts': 'makes the terms of every command',
    'cli/verify/play-options.ts': 'says in its help what holds',
    'editor/core/files/folder-list.ts': 'a page without a server has no configuration',
    'game/light/index.ts': 'a published entry that says its default',
    'game/play/verify.ts': 'a published entry that says its default',
    'game/player/index.ts': 'a published entry that says its default',
    'solver/search/anytime/anytime-proof.ts': 'a published entry that says its default',
    'solver/prove/setting.ts': 'a published entry that says its default',
    'solver/verify/claim.ts': 'reads what a proof of that entry claims',
    'solver/make/generate/generator-spec.ts': 'a published entry that says its default',
  };

  it('what holds where nothing is said is named where terms are made, and nowhere else', () => {
    const named = /\bDEFAULT_(MAX_TIME|MAX_TICKS|MAX_WORK|ACCURACY|TERMS)\b/;
    const users = Object.keys(ROOMS)
      .filter((room) => room !== 'engine')
      .flatMap(sourcesOf)
      .filter(({ text }) => named.test(text.replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, '')))
      .map(({ path }) => path);
    const known = Object.keys(ALLOWED);
    expect(known.filter((path) => !users.includes(path))).toEqual([]);
    expect(users.filter((path) => !known.includes(path))).toEqual([]);
  });
});

describe('the check for cycles finds one', () => {
  const circles = (files: Record<string, string>) =>
    circlesIn(importGraph(Object.entries(files).map(([path, text]) => ({ path, text }))));

  it.each([
    ['values', `import { b } from './b.ts';`],
    ['types', `import type { B } from './b.ts';`],
    ['a type among values', `import { type B, b } from './b.ts';`],
    ['a type in its place', `export type A = import('./b.ts').B;`],
    ['a re-export', `export * from './b.ts';`],
    ['a re-exported type', `export type { B } from './b.ts';`],
    ['an import on demand', `export const a = () => import('./b.ts');`],
    ['an import for its effects', `import './b.ts';`],
    ['the name of the built file', `import { b } from './b.js';`],
    ["a bundler's query", `import b from './b.ts?url';`],
  ])('by %s', (_, text) => {
    expect(circles({ 'cli/a.ts': text, 'cli/b.ts': `import { a } from './a.ts';` })).toEqual([
      'cli/a.ts -> cli/b.ts -> cli/a.ts',
    ]);
  });

  it('of one file, of three, and between rooms, with its complete path', () => {
    expect(circles({ 'cli/a.ts': `import './a.ts';` })).toEqual(['cli/a.ts -> cli/a.ts']);
    expect(
      circles({
        'cli/c.ts': `import './b/a.ts';`,
        'cli/b/a.ts': `import '../../bench/d.ts';`,
        'bench/d.ts': `import '../cli/c.ts';`,
      }),
    ).toEqual(['bench/d.ts -> cli/c.ts -> cli/b/a.ts -> bench/d.ts']);
  });

  it('in each of several groups, beside files that depend on them', () => {
    const files = {
      'cli/a.ts': `import './b.ts'; import './x.ts';`,
      'cli/b.ts': `import './c.ts'; import './a.ts';`,
      'cli/c.ts': `import './a.ts';`,
      'cli/x.ts': `import './y.ts';`,
      'cli/y.ts': `import './x.ts';`,
      'cli/above.ts': `import './a.ts';`,
    };
    expect(circles(files)).toEqual([
      'cli/a.ts -> cli/b.ts -> cli/a.ts',
      'cli/a.ts -> cli/b.ts -> cli/c.ts -> cli/a.ts',
      'cli/x.ts -> cli/y.ts -> cli/x.ts',
    ]);
  });

  it('but none if paths only join', () => {
    expect(circles({ 'cli/a.ts': `import './b.ts'; import './c.ts';`, 'cli/b.ts': `import './c.ts';`, 'cli/c.ts': '' })).toEqual(
      [],
    );
  });
});

describe('the check of imports finds a bypassed index file', () => {
  const faces = ['editor/canvas/index.ts', 'editor/canvas/layers/index.ts', 'editor/features/solver/index.ts'];
  const others = [
    'editor/canvas/colours.ts',
    'editor/canvas/layers/way.ts',
    'editor/features/solver/search.ts',
    'editor/features/bare/a.ts',
  ];
  const passed = (path: string, specifier: string) => {
    const text = `import type { A } from '${specifier}';`;
    const rest = [...faces, ...others].filter((other) => other !== path);
    return passedFaces(importGraph([{ path, text }, ...rest.map((other) => ({ path: other, text: '' }))]));
  };

  it.each([
    ['editor/features/solver/search.ts', '../../canvas/colours.ts', 'editor/canvas/index.ts'],
    ['editor/features/solver/search.ts', '../../canvas/layers/way.ts', 'editor/canvas/index.ts'],
    ['editor/features/solver/search.ts', '../../canvas/layers/index.ts', 'editor/canvas/index.ts'],
    ['editor/canvas/stage.ts', './layers/way.ts', 'editor/canvas/layers/index.ts'],
    ['editor/canvas/pointer/press.ts', '../layers/way.ts', 'editor/canvas/layers/index.ts'],
    ['editor/features/runs/a.ts', '../solver/search.ts', 'editor/features/solver/index.ts'],
    ['editor/features/runs/a.ts', '../bare/a.ts', 'editor/features/bare/index.ts'],
    ['editor/main.tsx', './features/solver/search.ts', 'editor/features/solver/index.ts'],
  ])('%s imports %s', (path, specifier, face) => {
    expect(passed(path, specifier)).toEqual([expect.stringMatching(`: passes by ${face}$`)]);
  });

  it.each([
    ['editor/features/solver/search.ts', '../../canvas/index.ts'],
    ['editor/features/runs/a.ts', '../solver/index.ts'],
    ['editor/canvas/stage.ts', './layers/index.ts'],
    ['editor/canvas/stage.ts', './colours.ts'],
    ['editor/canvas/layers/way.ts', '../colours.ts'],
    ['editor/canvas/layers/deep/a.ts', '../way.ts'],
    ['editor/main.tsx', './features/solver/index.ts'],
  ])('accepts %s: %s', (path, specifier) => expect(passed(path, specifier)).toEqual([]));
});

describe('the check of imports finds a violation', () => {
  const cases: [path: string, text: string, problem: RegExp][] = [
    ['schema/a.ts', `import { TICK } from '../engine/index.ts';`, /schema may not know engine\/index.ts/],
    ['schema/a.ts', `export type T = import('../engine/index.ts').Run;`, /schema may not know/],
    ['schema/a.ts', `import { commander } from 'commander';`, /schema may not use commander/],
    ['engine/a.ts', `import type { Level } from '../schema/level.ts';`, /not the face of its folder/],
    ['engine/arcade/a.ts', `export * from '../../cli/main.ts';`, /engine may not know cli/],
    ['engine/a.ts', `import fs from 'node:fs';`, /engine is no place for Node/],
    ['engine/a.ts', `const f = await import('node:fs');`, /engine is no place for Node/],
    ['engine/a.ts', `const name = 'node' + ':fs'; await import(name);`, /something computed/],
    ['engine/a.ts', `import Phaser from 'phaser';`, /Phaser/],
    ['engine/a.ts', `import '../tests/x.ts';`, /engine may not know tests/],
    ['cli/a.ts', `import Phaser from 'phaser';`, /Phaser/],
    ['phaser/a.ts', `import { Scene } from 'phaser';`, /only known by its types/],
    ['phaser/a.ts', `const all = await import('phaser');`, /only known by its types/],
    ['phaser/a.ts', `export { Scene } from 'phaser';`, /only known by its types/],
    ['game/a.ts', `import type { Scene } from 'phaser';`, /game may not know Phaser/],
    ['cli/a.ts', `import { Hash } from '../engine/hash.ts';`, /not the face of its folder/],
    ['cli/commands/a.ts', `import { x } from '../../editor/index.ts';`, /cli may not know editor/],
    ['editor/a.tsx', `import fs from 'node:fs';`, /editor is no place for Node/],
    ['editor/a.ts', `import { x } from '../cli/main.ts';`, /editor may not know cli/],
    ['editor/canvas/a.ts', `import { x } from '../app/index.ts';`, /editor\/app stands on it/],
    ['editor/features/runs/a.tsx', `import type { X } from '../../app/platform.ts';`, /editor\/app stands on it/],
    ['picture/a.ts', `import { x } from '../solver/index.ts';`, /picture may not know solver/],
    ['check/a.ts', `import { x } from '../picture/index.ts';`, /check may not know picture/],
    ['solver/a.ts', `import { x } from '../check/index.ts';`, /solver may not know check/],
    ['cli/check/a.ts', `import { x } from '../../check/verdict.ts';`, /not the face of its folder/],
    ['cli/a.ts', `import matter from 'matter-js';`, /not among the dependencies/],
    ['cli/a.ts', `import { y } from '@scope/name/deep';`, /@scope\/name is not among the dependencies/],
  ];
  it.each(cases)('%s: %s', (path, text, problem) => {
    expect(importProblems(path, text, runtime)).toEqual([expect.stringMatching(problem)]);
  });

  it.each([
    ['schema/a.ts', `import * as z from 'zod';`],
    ['engine/arcade/a.ts', `import type { Level } from '../../schema/index.ts';`],
    ['cli/a.ts', `import { findWarnings } from '../engine/warnings/index.ts'; import fs from 'node:fs';`],
    ['editor/a.ts', `import Phaser from 'phaser'; import { x } from '../solver/index.ts';`],
    ['phaser/a.ts', `import type { Scene } from 'phaser';`],
    ['editor/main.tsx', `import { App } from './app/index.ts';`],
    ['editor/app/a.ts', `import { x } from './b.ts'; import { y } from '../context/index.ts';`],
    ['engine/a.ts', `// import fs from 'node:fs'\nconst text = "import fs from 'node:fs'"; export { text };`],
  ])('accepts %s: %s', (path, text) => {
    expect(importProblems(path, text, path.startsWith('editor') ? bundled : runtime)).toEqual([]);
  });

  it('finds every form of import', () => {
    const text = `import a from './1.ts'; import type { B } from './2.ts'; export * from './3.ts'; export { c } from './4.ts';
      import './5.ts'; type D = import('./6.ts').D; const e = await import('./7.ts');`;
    expect(importsOf('engine/a.ts', text)).toEqual([1, 2, 3, 4, 5, 6, 7].map((n) => `./${n}.ts`));
  });
});

const IMPURE = [
  ...['sin', 'cos', 'tan', 'asin', 'acos', 'atan', 'atan2', 'exp', 'expm1', 'log', 'log2', 'log10', 'log1p', 'pow', 'hypot'].map(
    (f) => `export const a = Math.${f}(1, 2);`,
  ),
  ...['cbrt', 'sinh', 'cosh', 'tanh', 'random'].map((f) => `export const a = [1].map(Math.${f});`),
  'export const a = 2 ** 3;',
  'let a = 2; a **= 3; export { a };',
  `export const a = Math['sin'](1);`,
  'export const { sin } = Math;',
  'const m = Math; export const a = m.sin(1);',
  'export const a = Math.sqrt(Math.sin(1));',
  'export const a = globalThis.Math;',
  'export const a = Date.now();',
  'export const a = new Intl.NumberFormat();',
];

const PURE = [
  '// Math.sin(1), 2 ** 3\nexport const a = 1;',
  `export const a = 'Math.sin(1) ** 2 Date';`,
  'export const a = (x: number) => Math.sqrt(Math.abs(Math.min(x, Math.PI)));',
  'export const a = (s: { sin: number; cos: number }) => s.sin * s.cos;',
];

describe('the check of purity finds a violation', () => {
  it.each(IMPURE)('%s', (text) => expect(purityProblems('engine/a.ts', text)).toHaveLength(1));
  it.each(PURE)('accepts %s', (text) => expect(purityProblems('engine/a.ts', text)).toEqual([]));
});

describe('the linter finds a violation', () => {
  const bad: [path: string, text: string][] = [
    ...['schema', 'engine', 'solver', 'check'].flatMap((room) => IMPURE.map((text): [string, string] => [room, text])),
    ...['schema', 'engine', 'solver', 'check'].map((room): [string, string] => [room, `import a from 'node:fs'; export { a };`]),
    ...['schema', 'engine', 'cli'].map((room): [string, string] => [room, `import a from 'phaser'; export { a };`]),
    ['schema', `export * from '../engine/index.ts';`],
    ['engine', `export * from '../schema/level.ts';`],
    ['engine', `export * from '../cli/main.ts';`],
    ['engine', `export * from '../solver/index.ts';`],
    ['solver', `export * from '../engine/hash.ts';`],
    ['solver', `export * from '../cli/main.ts';`],
    ['solver', `export * from '../check/index.ts';`],
    ['check', `export * from '../solver/random.ts';`],
    ['check', `export * from '../picture/index.ts';`],
    ['check', `export * from '../cli/main.ts';`],
    ['cli/commands', `export * from '../../check/verdict.ts';`],
    ['cli', `export * from '../engine/hash.ts';`],
    ['cli', `export * from '../tests/a.ts';`],
    ['cli', `export * from '../picture/text.ts';`],
    ['picture', 'export const a = Date.now();'],
    ['picture', `export * from '../engine/hash.ts';`],
    ['picture', `export * from '../solver/index.ts';`],
    ['editor', `import a from 'node:fs'; export { a };`],
    ['editor', `export * from '../engine/hash.ts';`],
    ['editor', `export * from '../check/verdict.ts';`],
    ['editor', `export * from '../cli/main.ts';`],
  ];
  const good: [path: string, text: string][] = [
    ...['schema', 'engine', 'solver', 'check'].flatMap((room) => PURE.map((text): [string, string] => [room, text])),
    ['engine', `export * from '../schema/index.ts';`],
    ['solver', `export * from '../engine/index.ts';`],
    ['check', `export * from '../solver/index.ts'; export * from '../engine/index.ts';`],
    ['cli/commands', `export * from '../../check/words/index.ts'; export * from '../check/summary.ts';`],
    ['editor', `export * from '../check/words/index.ts';`],
    ['cli', `import a from 'node:fs'; export { a }; export * from '../engine/index.ts';`],
    ['picture', 'export const a = Math.sin(1);'],
    ['editor', `import a from 'phaser'; export { a }; export * from '../solver/index.ts';`],
    ['cli', 'export const a = Math.sin(1) + 2 ** 3 + Date.now();'],
  ];
  const name = (kind: string, room: string, i: number) => `${room}/${kind}-${i}.ts`;
  const reported = new Set<string>();
  let folder = '';

  // one run of the real linter over all snippets, in a project of their own
  beforeAll(() => {
    folder = mkdtempSync(join(tmpdir(), 'gq-lint-'));
    for (const part of ['biome.json', 'lint', '.gitignore']) cpSync(join(root, part), join(folder, part), { recursive: true });
    for (const [kind, list] of [['bad', bad] as const, ['good', good] as const]) {
      for (const [i, [room, text]] of list.entries()) {
        mkdirSync(join(folder, room), { recursive: true });
        writeFileSync(join(folder, name(kind, room, i)), `${text}\n`);
      }
    }
    const biome = join(dirname(createRequire(import.meta.url).resolve('@biomejs/biome/package.json')), 'bin', 'biome');
    const only = ['noRestrictedImports', 'noRestrictedGlobals'].flatMap((rule) => ['--only', `style/${rule}`]);
    const args = [biome, 'lint', ...only, '--only', 'plugin', '--max-diagnostics=none', '--reporter=json', '.'];
    let out = '';
    try {
      out = execFileSync(process.execPath, args, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] });
    } catch (error) {
      out = (error as { stdout: string }).stdout;
    }
    for (const { location, severity } of JSON.parse(out.slice(out.indexOf('{'))).diagnostics) {
      const path = typeof location.path === 'string' ? location.path : location.path.file;
      if (severity === 'error') reported.add(path.split(sep).join('/').replace(/^\.\//, ''));
    }
  });
  afterAll(() => rmSync(folder, { recursive: true, force: true }));

  it.each(bad.map(([room, text], i) => [room, text, i] as const))('%s: %s', (room, _, i) => {
    expect([...reported]).toContain(name('bad', room, i));
  });
  it.each(good.map(([room, text], i) => [room, text, i] as const))('accepts %s: %s', (room, _, i) => {
    expect([...reported]).not.toContain(name('good', room, i));
  });
});

describe('the project mentions only itself', () => {
  const isText = (path: string) => !readFileSync(path).subarray(0, 8000).includes(0);

  it('contains no path of a machine and no host of a registry', () => {
    const files = filesUnder(root).filter((path) => statSync(path).size < 5e6 && isText(path));
    expect(files.length).toBeGreaterThan(20);
    const found = files.flatMap((path) => machineWords(readFileSync(path, 'utf8')).map((word) => `${fromRoot(path)}:${word}`));
    expect(found).toEqual([]);
  });

  const slash = '/';
  it.each([
    `see ${slash}work/main`,
    `'${slash}shared/truth'`,
    `cd ${slash}home/me`,
    `"${slash}Users/me"`,
    `"C:${'\\'}Users${'\\'}me"`,
    `"https:${slash}${slash}registry${'.'}npmjs.org/x"`,
    `"http:${slash}${slash}10.0${'.'}0.7:4873/zod"`,
  ])('finds %s', (text) => expect(machineWords(text)).toHaveLength(1));

  it.each([
    `..${slash}shared${slash}truth`,
    `docs${slash}work${slash}a`,
    'a/home',
    'frameworks',
    `x ${slash}workers`,
    `https:${slash}${slash}example.org${slash}work`,
    '1.10.2.3',
  ])('accepts %s', (text) => expect(machineWords(text)).toEqual([]));
});
