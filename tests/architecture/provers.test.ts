import { readdirSync, readFileSync } from 'node:fs';
import { join, sep } from 'node:path';
import { expect, it } from 'vitest';
import { PROJECT } from '../docs/page.ts';
import { importGraph } from './import-graph.ts';

// What proves and what checks proofs share no code, so that one mistake cannot stand in both.

const sources = readdirSync(join(PROJECT, 'solver'), { recursive: true, encoding: 'utf8' })
  .map((path) => `solver/${path.split(sep).join('/')}`)
  .filter((path) => path.endsWith('.ts'))
  .map((path) => ({ path, text: readFileSync(join(PROJECT, path), 'utf8') }));
const graph = importGraph(sources);
const isIn = (folder: string) => (path: string) => path.startsWith(`solver/${folder}/`);

it('no prover knows a checker', () => {
  const wrong = [...graph].filter(([path, targets]) => isIn('prove')(path) && targets.some(isIn('verify')));
  expect(wrong.map(([path]) => path)).toEqual([]);
});

it('a checker knows of the provers only the types of what they claim, and nothing else of the solver', () => {
  const checkers = sources.filter(({ path }) => isIn('verify')(path));
  expect(checkers.length).toBeGreaterThan(20);
  const outside = checkers.flatMap(({ path }) =>
    (graph.get(path) ?? []).filter((target) => !isIn('verify')(target)).map((target) => `${path} -> ${target}`),
  );
  expect(outside.filter((arrow) => !arrow.endsWith('-> solver/prove/index.ts'))).toEqual([]);
  const values = checkers.filter(({ text }) => /^(?:import|export) (?!type )[^;]*from '[./]*prove\/index\.ts';/m.test(text));
  expect(values.map(({ path }) => path)).toEqual([]);
});
