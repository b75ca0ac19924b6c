import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, expect, it } from 'vitest';
import { fingerprint, isSiteSource, isSource, SITE_SOURCES, SOURCES } from '../editor/page-sources.mjs';

// The page is built again only if its sources have another fingerprint than at the last build.

let project = '';
const put = (path: string, text: string): void => {
  mkdirSync(dirname(join(project, path)), { recursive: true });
  writeFileSync(join(project, path), text);
};
beforeEach(() => {
  project = mkdtempSync(join(tmpdir(), 'gq-page-'));
  for (const source of SOURCES) put(source.includes('.') ? source : `${source}/deep/a.ts`, source);
});
afterEach(() => rmSync(project, { recursive: true, force: true }));

it('a copy of the project has the same fingerprint, whatever else is in it', () => {
  const copy = mkdtempSync(join(tmpdir(), 'gq-page-'));
  cpSync(project, copy, { recursive: true });
  writeFileSync(join(copy, 'README.md'), 'more');
  expect(fingerprint(copy)).toBe(fingerprint(project));
  rmSync(copy, { recursive: true });
});

it('any change to a source changes the fingerprint', () => {
  const seen = [fingerprint(project)];
  const changes = [
    ...SOURCES.map((source) => () => put(source.includes('.') ? source : `${source}/deep/a.ts`, 'changed')),
    () => put('engine/new.ts', ''),
    () => put('engine/newer.ts', ''),
    () => rmSync(join(project, 'engine/newer.ts')),
    () => rmSync(join(project, 'solver/deep/a.ts')),
  ];
  for (const change of changes) {
    change();
    seen.push(fingerprint(project));
  }
  // the file that came and went
  expect(seen.at(-2)).toBe(seen.at(-4));
  expect(new Set(seen).size).toBe(seen.length - 1);
});

it.runIf(process.platform !== 'win32')('whatever else stands in a folder is left out', () => {
  const before = fingerprint(project);
  symlinkSync('nowhere', join(project, 'levels/nowhere.level.json'));
  symlinkSync('.', join(project, 'levels/round'));
  put('levels/.gq-trash/old.level.json', 'old');
  execFileSync('mkfifo', [join(project, 'levels/pipe.level.json')]);
  expect(fingerprint(project)).toBe(before);
});

it.each([
  ['engine/index.ts', true],
  ['levels/01.level.json?raw', true],
  ['node_modules/phaser/phaser.js', true],
  ['cli/main.ts', false],
  ['engine-room/index.ts', false],
  ['../elsewhere.ts', false],
])('%s: a source or in a package: %s', (path, is) => {
  expect(isSource('/project', join('/project', path))).toBe(is);
});

it('the game of gq build is built again when one of its sources has changed, and not for other files', () => {
  const path = (source: string) => (source.includes('.') ? source : `${source}/a.ts`);
  for (const source of SITE_SOURCES) put(path(source), source);
  const seen = [fingerprint(project, SITE_SOURCES)];
  put('examples/phaser/dist/game.js', 'built');
  put('editor/more.ts', 'more');
  expect(fingerprint(project, SITE_SOURCES)).toBe(seen[0]);
  for (const source of SITE_SOURCES) {
    put(path(source), 'changed');
    seen.push(fingerprint(project, SITE_SOURCES));
  }
  expect(new Set(seen).size).toBe(seen.length);
});

it.each([
  ['dist/engine/index.js', true],
  ['examples/phaser/src/main.ts', true],
  ['examples/phaser/src/style.css?inline', true],
  ['node_modules/phaser/dist/phaser.js', true],
  ['examples/other/main.ts', false],
  ['dist/gq/main.js', false],
  ['../elsewhere.ts', false],
])('%s: a source of the game or in a package: %s', (path, is) => {
  expect(isSiteSource('/project', join('/project', path))).toBe(is);
});
