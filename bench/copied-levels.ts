import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { LevelFile } from '../schema/index.ts';
import { optionValue } from './harness.ts';
import { movedLevel } from './moved-level.ts';

/** The shipped levels, or those of a directory given with --levels. */
const SHIPPED = optionValue('--levels') ?? fileURLToPath(new URL('../../levels/', import.meta.url));

/** Levels with a run each, made in turn from the shipped levels that have one. */
export function copiedLevels(count: number): LevelFile[] {
  const shipped = readdirSync(SHIPPED)
    .filter((name) => name.endsWith('.level.json'))
    .map((name) => JSON.parse(readFileSync(join(SHIPPED, name), 'utf8')) as LevelFile)
    .filter((file) => (file.runs?.length ?? 0) > 0);
  if (shipped.length === 0) throw new Error(`expected level files with a run in ${SHIPPED}, found none`);
  return Array.from({ length: count }, (_, i) => {
    const file = shipped[i % shipped.length];
    return { ...movedLevel(file, i % 1000, -2 * (i % 1000)), name: `Moved ${i}`, runs: file.runs?.slice(0, 1) };
  });
}

/** Writes such levels into the files of a directory. */
export function writeCopies(directory: string, count: number): void {
  for (const [i, level] of copiedLevels(count).entries()) {
    writeFileSync(join(directory, `${String(i).padStart(4, '0')}.level.json`), `${JSON.stringify(level, null, 2)}\n`);
  }
}
