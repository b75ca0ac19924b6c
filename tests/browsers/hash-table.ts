import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { ACCURACIES } from '../../engine/index.ts';
import { hashOf } from './entry.ts';
import type { HashedRun } from './scenes.ts';

/** Run by name, then accuracy by name: the hash. */
export type HashTable = Record<string, Record<string, string>>;

/** The table that is committed; an empty one where there is none yet. */
export function committedTable(): HashTable {
  const file = join(import.meta.dirname, 'hashes.json');
  return existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')) : {};
}

/** What to ask an engine, in the order of the table: level, holds and accuracy as text. */
export const questions = (runs: readonly HashedRun[]): [level: string, holds: string, accuracy: string][] =>
  runs.flatMap(({ level, holds }) =>
    Object.keys(ACCURACIES).map((accuracy): [string, string, string] => [JSON.stringify(level), JSON.stringify(holds), accuracy]),
  );

/** The answers in the order of {@link questions} as a table. */
export function tableOf(runs: readonly HashedRun[], answers: readonly string[]): HashTable {
  const names = Object.keys(ACCURACIES);
  return Object.fromEntries(
    runs.map((run, i) => [run.name, Object.fromEntries(names.map((name, k) => [name, answers[i * names.length + k]]))]),
  );
}

/** The table as this very process computes it. */
export const tableHere = (runs: readonly HashedRun[]): HashTable =>
  tableOf(
    runs,
    questions(runs).map(([level, holds, accuracy]) => hashOf(level, holds, accuracy)),
  );
