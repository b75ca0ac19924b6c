import { basename, join } from 'node:path';
import { MAX_FILE_SIZE } from '../schema/basics/index.ts';
import { readRegularFile } from './regular-file.ts';

/** A name that is nearly that of a level file: `far.json`, `far.level.json.txt`, `far.level.txt`. */
const NEARLY = /^([^.].*?)(?:\.level)?\.json$|^([^.].*?)\.level(?:\.json)?(?:\.\w+)?$/i;

/** Files that are opened to see whether they hold a level, and those that a message names. */
const MOST_OPENED = 100;
const MOST_NAMED = 3;

export const isNearlyLevelName = (path: string): boolean => NEARLY.test(basename(path));

/** What a file should be called to be found in a directory. */
function levelName(path: string): string {
  const [, ofJson, ofLevel] = NEARLY.exec(basename(path)) ?? [];
  return `${ofJson ?? ofLevel}.level.json`;
}

/** Whether a file holds what every level has; one that cannot be read is none. */
function looksLikeLevel(path: string): boolean {
  try {
    const text = Buffer.from(readRegularFile(path, MAX_FILE_SIZE)).toString();
    return text.includes('"blackHole"') && text.includes('"astronaut"');
  } catch {
    return false;
  }
}

/** For a directory without a level file: `; far.json looks like a level: …` for each file that only has another name, else nothing. */
export function nearLevelsHint(files: readonly string[]): string {
  const near = files.slice(0, MOST_OPENED).filter(looksLikeLevel);
  const named = near
    .slice(0, MOST_NAMED)
    .map((path) => `; ${join(path)} looks like a level: did you mean to call it ${levelName(path)}?`);
  return named.join('') + (near.length > MOST_NAMED ? `; and ${near.length - MOST_NAMED} more` : '');
}
