import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { importOriginal, type Level, readLevel, resolveLevel } from '../schema/index.ts';
import { optionValue } from './harness.ts';

const PACK = fileURLToPath(new URL('../../levels/', import.meta.url));

export interface NamedLevel {
  readonly name: string;
  readonly level: Level;
}

/**
 * The levels of a folder; the shipped ones when left out.
 * @throws {Error} if one is not valid, or there is none
 */
export function packLevels(folder = PACK): NamedLevel[] {
  const files = readdirSync(folder).filter((file) => file.endsWith('.level.json'));
  if (files.length === 0) throw new Error(`expected levels in ${folder}, found none`);
  return files.sort().map((file) => {
    const read = readLevel(readFileSync(join(folder, file)));
    if (!read.ok) throw new Error(`expected a valid level in ${file}: ${read.problems[0].message}`);
    return { name: file.replace('.level.json', ''), level: read.level };
  });
}

/**
 * The levels in a file of the original game; with recoil as there, unless it is turned off.
 * @throws {Error} if they cannot be imported
 */
export function originalLevels(file: string, recoil = true): NamedLevel[] {
  const imported = importOriginal(readFileSync(file), { recoil });
  if (!imported.ok) throw new Error(`expected the original's levels in ${file}: ${imported.problems[0].message}`);
  return imported.levels.map(({ slug, file: level }) => ({ name: slug, level: resolveLevel(level) }));
}

/** The levels that the command line asks for: `--originals FILE [--recoil off]`, `--levels DIR`, or else the shipped levels. */
export function askedLevels(): NamedLevel[] {
  const originals = optionValue('--originals');
  return originals === null
    ? packLevels(optionValue('--levels') ?? undefined)
    : originalLevels(originals, optionValue('--recoil') !== 'off');
}
