import { realpathSync } from 'node:fs';
import { formatLevel, type LevelFile } from '../schema/index.ts';
import { Failure, readBytes, replaceFile, systemReason, whyNotWritable } from './io/index.ts';

/**
 * Writes a level file in the canonical layout, in place of the one that was read before a search.
 * @param base the bytes that were read
 * @param file the new content
 * @param remedy what to do if the file has changed since
 * @throws Failure if the file has changed since, or can't be written
 */
export function replaceLevel(path: string, base: Uint8Array, file: LevelFile, remedy: string): void {
  const content = Buffer.from(formatLevel(file));
  try {
    // a link stays a link: the file that it leads to is replaced
    const real = realpathSync(path);
    replaceFile(real, content, () => {
      if (Buffer.compare(readBytes(real), base) === 0) return;
      throw new Failure(`${path}: the file changed during the search, so nothing was written: ${remedy}`);
    });
  } catch (error) {
    if (error instanceof Failure) throw error;
    throw new Failure(`${path}: can't be written: ${systemReason(error)}`);
  }
}

/** Checks before a long search whether its result can be written. @throws Failure if it can't */
export function expectWritable(path: string): void {
  const why = whyNotWritable(path);
  if (why !== null) throw new Failure(`${path}: --write can't write it: ${why}`);
}
