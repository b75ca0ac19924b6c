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

/** `--recoil on|off`; null where it is left out. */
function askedRecoil(): boolean | null {
  const given = optionValue('--recoil');
  if (given === null) return null;
  if (given === 'on' || given === 'off') return given === 'on';
  throw new Error(`expected on or off after --recoil, found ${given}`);
}

/**
 * The levels that the command line asks for: `--originals FILE`, `--levels DIR`, or else the shipped levels. `--recoil on|off`
 * changes all of them; left out, the originals have recoil, and other levels what their files say.
 */
export function askedLevels(): NamedLevel[] {
  const originals = optionValue('--originals');
  const recoil = askedRecoil();
  if (originals !== null) return originalLevels(originals, recoil ?? true);
  const levels = packLevels(optionValue('--levels') ?? undefined);
  return recoil === null ? levels : levels.map(({ name, level }) => ({ name, level: { ...level, recoil } }));
}
