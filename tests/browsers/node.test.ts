import { expect, it } from 'vitest';
import { committedTable, questions, tableHere } from './hash-table.ts';
import { hashedRuns } from './scenes.ts';

it('hashes of runs in Node are the committed ones (npm run hashes rewrites them)', () => {
  const runs = hashedRuns();
  const table = tableHere(runs);
  expect(table).toEqual(committedTable());
  // what differs in level, holds or accuracy must differ in its hash; of the hard cases many are misses on one and the same path
  const distinct = runs.filter(({ name }) => !name.startsWith('hard: '));
  const hashes = distinct.flatMap(({ name }) => Object.values(table[name]));
  expect(new Set(hashes).size).toBe(new Set(questions(distinct).map((question) => question.join())).size);
});
