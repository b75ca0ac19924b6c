import { readdirSync, readFileSync } from 'node:fs';
import { join, sep } from 'node:path';
import { expect, it } from 'vitest';
import { PROJECT } from '../docs/page.ts';
import { importGraph, type Source } from './import-graph.ts';
import { importsOf } from './inspect-source.ts';

// What tests and benchmarks share stands in folders of its own in tests/, so that neither stands on the other.

/** Each is written to dist/tests/ by `tests/tsconfig.shared.json`. */
const SHARED = ['scenes', 'judges', 'attackers', 'interrupted'].map((folder) => `tests/${folder}/`);

const sourcesIn = (folder: string): Source[] =>
  readdirSync(join(PROJECT, folder), { recursive: true, encoding: 'utf8' })
    .map((path) => `${folder}/${path.split(sep).join('/')}`)
    .filter((path) => /\.tsx?$/.test(path))
    .map((path) => ({ path, text: readFileSync(join(PROJECT, path), 'utf8') }));

const sources = [...sourcesIn('tests'), ...sourcesIn('bench')];
const arrows = [...importGraph(sources)].flatMap(([path, targets]) => targets.map((target) => ({ path, target })));
const isShared = (path: string): boolean => SHARED.some((folder) => path.startsWith(folder));
const told = ({ path, target }: (typeof arrows)[number]): string => `${path} -> ${target}`;

it('only the tests of a benchmark know it', () => {
  const wrong = arrows.filter(
    ({ path, target }) => path.startsWith('tests/') && !path.startsWith('tests/bench/') && target.startsWith('bench/'),
  );
  expect(wrong.map(told)).toEqual([]);
});

it('benchmarks know no tests, only what they share with them', () => {
  const wrong = arrows.filter(
    ({ path, target }) => path.startsWith('bench/') && target.startsWith('tests/') && !isShared(target),
  );
  expect(wrong.map(told)).toEqual([]);
});

it('what they share stands on the rooms alone', () => {
  const shared = sources.filter(({ path }) => isShared(path));
  expect(shared.length).toBeGreaterThan(40);
  expect(arrows.filter(({ path, target }) => isShared(path) && !isShared(target)).map(told)).toEqual([]);
  const packages = shared.flatMap(({ path, text }) => importsOf(path, text).map((name) => ({ path, name })));
  expect(packages.filter(({ name }) => !/^(\.|node:)/.test(name ?? '')).map(({ path, name }) => `${path}: ${name}`)).toEqual([]);
});
