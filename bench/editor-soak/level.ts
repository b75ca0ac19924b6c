import { chownSync, readFileSync, renameSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { formatLevel, type LevelFile, readLevel } from '../../schema/index.ts';

/** The level that is edited: the page moves its objects, other programs count in its name. */
export const FILE = 'soak.level.json';

/** Where the asteroid is at first, px; a number of four digits, like all of its places. */
export const START = 1000;

/** More than one KiB, so that a disk without room for it can be made. */
const NOTE = 'Something to say. '.repeat(80);

export const soakLevel = (): string =>
  formatLevel({
    version: 1,
    name: 'Soak 0',
    description: NOTE,
    astronaut: { x: START - 100, y: 0 },
    blackHole: { x: START, y: 400 },
    range: 100_000,
    asteroids: [{ id: 'rock', x: START, y: 0, radius: 32 }],
    runs: [{ name: 'solution', holds: [[0, 60]] }],
  });

/** How often the page and other programs have changed the level. */
export interface Counts {
  readonly page: number;
  readonly others: number;
}

function fileOf(text: string): LevelFile {
  const reading = readLevel(text);
  if (!reading.ok) throw new Error(`damaged: ${reading.problems[0].message}`);
  return reading.document.file;
}

const countOfOthers = ({ name }: LevelFile): number => Number(/^Soak (\d+)$/.exec(name)?.[1]);

/**
 * Reads the counts from the file.
 * @throws {Error} if it is damaged or missing
 */
export function countsOnDisk(folder: string): Counts {
  const file = fileOf(readFileSync(join(folder, FILE), 'utf8'));
  return { page: (file.asteroids?.[0]?.x ?? Number.NaN) - START, others: countOfOthers(file) };
}

/**
 * Rewrites the level as other programs do; the file keeps its owner. It is read again at the last moment, so that what the
 * editor has written in between is not undone.
 */
function rewrite(folder: string, change: (text: string) => string): { before: string; after: string } {
  const path = join(folder, FILE);
  const aside = join(folder, '.by-others.tmp');
  const { uid, gid } = statSync(folder);
  for (;;) {
    const before = readFileSync(path, 'utf8');
    const after = change(before);
    writeFileSync(aside, after);
    chownSync(aside, uid, gid);
    if (readFileSync(path, 'utf8') !== before) continue;
    renameSync(aside, path);
    return { before, after };
  }
}

/** Changes the level as another program. */
export function changeByOthers(folder: string): void {
  rewrite(folder, (text) => {
    const file = fileOf(text);
    return formatLevel({ ...file, name: `Soak ${countOfOthers(file) + 1}` });
  });
}

/**
 * Removes the level, as a checkout does.
 * @returns a function that puts it back, unless there is another file
 */
export function takeAway(folder: string): () => void {
  const path = join(folder, FILE);
  const aside = join(folder, '.away.tmp');
  renameSync(path, aside);
  return () => {
    if (statSync(path, { throwIfNoEntry: false }) === undefined) renameSync(aside, path);
    else rmSync(aside);
  };
}

/**
 * Leaves a file with errors, as a merge with conflicts does.
 * @returns a function that repairs it; it throws if somebody has overwritten it
 */
export function tear(folder: string): () => void {
  const { before, after } = rewrite(folder, (text) => text.replace('"range"', '<<<<<<< HEAD\n  "range"'));
  return () => {
    rewrite(folder, (text) => {
      if (text !== after) throw new Error('a file with errors was written over');
      return before;
    });
  };
}
