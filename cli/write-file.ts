import { realpathSync, statSync, writeFileSync } from 'node:fs';
import { replaceFile } from './disk.ts';
import { Failure, systemReason } from './failure.ts';

/** Where a path leads when links are followed; itself when nothing is there. */
function followed(path: string): string {
  try {
    return realpathSync(path);
  } catch {
    return path;
  }
}

/**
 * Writes a file whole or not at all, and keeps the mode of one that exists. A device or pipe is written to as it is.
 * @throws Failure saying why it can't be written
 */
export function writeWhole(path: string, content: string | Uint8Array): void {
  const bytes = typeof content === 'string' ? Buffer.from(content) : content;
  try {
    const target = followed(path);
    const isFile = statSync(target, { throwIfNoEntry: false })?.isFile() ?? true;
    if (isFile) replaceFile(target, bytes, () => {});
    else writeFileSync(target, bytes);
  } catch (error) {
    throw new Failure(`${path}: can't be written: ${systemReason(error)}`);
  }
}
