import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { LevelFile } from '../schema/index.ts';
import { optionValue } from './harness.ts';
import { movedLevel } from './moved-level.ts';

/** The shipped levels, or those of a directory given with --levels. */
const SHIPPED = optionValue('--levels') ?? fileURLToPath(new URL('../../levels/', import.meta.url));

/** Writes level files into `directory`, each with a run, made in turn from the shipped levels that have one. */
export function writeCopies(directory: string, count: number): void {
  const shipped = readdirSync(SHIPPED)
    .filter((name) => name.endsWith('.level.json'))
    .map((name) => JSON.parse(readFileSync(join(SHIPPED, name), 'utf8')) as LevelFile)
    .filter((file) => (file.runs?.length ?? 0) > 0);
  if (shipped.length === 0) throw new Error(`expected level files with a run in ${SHIPPED}, found none`);
  for (let i = 0; i < count; i++) {
    const name = `Moved ${i}`;
    const file = shipped[i % shipped.length];
    const moved = { ...movedLevel(file, i, -2 * i), name, runs: file.runs?.slice(0, 1) };
    writeFileSync(join(directory, `${String(i).padStart(4, '0')}.level.json`), `${JSON.stringify(moved, null, 2)}\n`);
  }
}
