import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { importOriginal, type Level, type LevelFile, readLevel, resolveLevel } from '../../schema/index.ts';
import { PROJECT } from './gq.ts';
import { movedLevel } from './moved-level.ts';
import { type Asked, oneOf, text } from './record.ts';

const SHIPPED = join(PROJECT, 'levels');
const ENDING = '.level.json';

export interface NamedFile {
  readonly name: string;
  readonly file: LevelFile;
}

export interface NamedLevel {
  readonly name: string;
  readonly level: Level;
}

/**
 * The level files of a folder.
 * @throws {Error} if one is not valid, or there is none
 */
export function packFiles(folder = SHIPPED): NamedFile[] {
  const files = readdirSync(folder).filter((file) => file.endsWith(ENDING));
  if (files.length === 0) throw new Error(`expected levels in ${folder}, found none`);
  return files.sort().map((file) => {
    const read = readLevel(readFileSync(join(folder, file)));
    if (!read.ok) throw new Error(`expected a valid level in ${file}: ${read.problems[0].message}`);
    return { name: file.replace(ENDING, ''), file: read.document.file };
  });
}

/**
 * The level files in a file of the original game; with recoil as there, unless it is turned off.
 * @throws {Error} if they cannot be imported
 */
export function originalFiles(file: string, recoil = true): NamedFile[] {
  const imported = importOriginal(readFileSync(file), { recoil });
  if (!imported.ok) throw new Error(`expected the original's levels in ${file}: ${imported.problems[0].message}`);
  return imported.levels.map(({ slug, file: level }) => ({ name: slug, file: level }));
}

const resolved = ({ name, file }: NamedFile): NamedLevel => ({ name, level: resolveLevel(file) });

/** The levels of a folder; the shipped ones when left out. */
export const packLevels = (folder = SHIPPED): NamedLevel[] => packFiles(folder).map(resolved);

/** The options by which the levels are chosen. */
export const LEVELS = {
  originals: text("a file of the original game's levels"),
  levels: text('a folder of levels instead of the shipped ones'),
  recoil: oneOf(['on', 'off'] as const, null, 'changes all of them'),
};

/** The levels that are asked for. Where recoil is left out, the originals have it, and other levels what their files say. */
export function askedLevels({ originals, levels, recoil }: Asked<typeof LEVELS>): NamedLevel[] {
  if (originals !== null) return originalFiles(originals, recoil !== 'off').map(resolved);
  const pack = packLevels(levels ?? SHIPPED);
  return recoil === null ? pack : pack.map(({ name, level }) => ({ name, level: { ...level, recoil: recoil === 'on' } }));
}

/** Level files with a run each, made in turn from those of a folder that have one, each moved as a whole by some px. */
export function copiedLevels(count: number, folder = SHIPPED): LevelFile[] {
  const files = packFiles(folder).filter(({ file }) => (file.runs?.length ?? 0) > 0);
  if (files.length === 0) throw new Error(`expected level files with a run in ${folder}, found none`);
  return Array.from({ length: count }, (_, i) => {
    const { file } = files[i % files.length];
    return { ...movedLevel(file, i % 1000, -2 * (i % 1000)), name: `Moved ${i}`, runs: file.runs?.slice(0, 1) };
  });
}

/** Writes levels into numbered files of a folder. */
export function writeLevels(folder: string, levels: readonly LevelFile[]): void {
  for (const [i, level] of levels.entries()) {
    writeFileSync(join(folder, `${String(i).padStart(4, '0')}${ENDING}`), `${JSON.stringify(level, null, 2)}\n`);
  }
}

/** Writes levels into one file, a line each. */
export const writeLines = (path: string, levels: readonly object[]): void =>
  writeFileSync(path, levels.map((level) => `${JSON.stringify(level)}\n`).join(''));
