import { appendFileSync } from 'node:fs';
import { dirname } from 'node:path';
import type { ResultFile } from './command.ts';
import { Failure, systemReason } from './failure.ts';
import { makeFolders } from './make-folders.ts';
import { uncut } from './signals.ts';
import { writePieces, writeWhole } from './write-file.ts';

/**
 * Writes the files of a result. One that can't be written does not keep the others from being written.
 * @returns why a file could not be written, for each such file, and whether the command has failed because of it
 */
export async function writeResultFiles(files: readonly ResultFile[]): Promise<{ messages: string[]; failed: boolean }> {
  const messages: string[] = [];
  let failed = false;
  for (const file of files) {
    try {
      await write(file);
    } catch (error) {
      if (!(error instanceof Failure)) throw error;
      const isReport = file.mode === 'replace';
      if (isReport) failed = true;
      messages.push(`${isReport ? 'error' : 'warning'}: ${error.message}`);
    }
  }
  return { messages, failed };
}

async function write({ path, content, mode }: ResultFile): Promise<void> {
  if (mode === 'replace') {
    makeFolder(path);
    return typeof content === 'string' || content instanceof Uint8Array ? writeWhole(path, content) : writePieces(path, content);
  }
  await uncut(() => {
    try {
      for (const piece of typeof content === 'string' || content instanceof Uint8Array ? [content] : content)
        appendFileSync(path, piece);
    } catch (error) {
      throw new Failure(`${path}: can't be written: ${systemReason(error)}`);
    }
  });
}

function makeFolder(path: string): void {
  try {
    makeFolders(dirname(path));
  } catch (error) {
    throw new Failure(`${path}: its folder can't be made: ${systemReason(error)}`);
  }
}
