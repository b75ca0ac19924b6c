import { closeSync, existsSync, lstatSync, openSync, statSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { renamePatiently, replaceFile } from './disk.ts';
import { Failure, systemReason } from './failure.ts';
import { LineWriter } from './line-writer.ts';
import { realTarget } from './real-target.ts';
import { shellPath } from './shown-path.ts';
import { hearSignals, uncut, withUndo } from './signals.ts';
import { whyNotWritable } from './writable.ts';

/** Whether something is there that is no file. A pipe behind /dev/stdout has no path of its own, so links are not followed by name. */
function isDevice(path: string): boolean {
  const stats = tryTo(path, () => statSync(path, { throwIfNoEntry: false }));
  return stats !== undefined && !stats.isFile();
}

/**
 * Writes a file completely or not at all, and keeps the mode of an existing file. A device or pipe is written directly.
 * @throws Failure with the reason if it can't be written
 */
export async function writeWhole(path: string, content: string | Uint8Array): Promise<void> {
  const bytes = typeof content === 'string' ? Buffer.from(content) : content;
  // writing may wait for a reader, and a signal must be able to end that
  if (isDevice(path)) return tryTo(path, () => writeFileSync(path, bytes));
  const target = tryTo(path, () => realTarget(path));
  await uncut(() => tryTo(path, () => replace(target, bytes)));
}

/**
 * Writes a file piece by piece, completely or not at all: for one that is too large for memory.
 * @throws Failure with the reason if it can't be written
 */
export async function writePieces(path: string, pieces: Iterable<string>): Promise<void> {
  if (isDevice(path)) {
    const descriptor = tryTo(path, () => openSync(path, 'w'));
    try {
      for (const piece of pieces) tryTo(path, () => writeFileSync(descriptor, piece));
    } finally {
      closeSync(descriptor);
    }
    return;
  }
  const target = tryTo(path, () => realTarget(path));
  const why = existsSync(target) ? whyNotWritable(target) : null;
  if (why !== null) throw new Failure(`${path}: can't be written: ${why}`);
  const out = tryTo(path, () => new LineWriter(target));
  const discard = (): void => out.discard();
  try {
    await withUndo(discard, async () => {
      let heard = performance.now();
      for (const piece of pieces) {
        tryTo(path, () => out.write(piece));
        if (performance.now() - heard < SLICE) continue;
        await hearSignals();
        heard = performance.now();
      }
      tryTo(path, () => out.end());
      tryTo(path, () => renamePatiently(out.unfinished, target));
    });
  } finally {
    discard();
  }
}

/** ms between two looks at signals */
const SLICE = 20;

/** The same within work that no signal may interrupt; only for a regular file, or a path without a file. */
export function replaceRegular(path: string, content: Uint8Array): void {
  tryTo(path, () => {
    const target = realTarget(path);
    if (statSync(target, { throwIfNoEntry: false })?.isFile() === false) throw new Error('it is not a regular file');
    replace(target, content);
  });
}

function replace(target: string, bytes: Uint8Array): void {
  const why = lstatSync(target, { throwIfNoEntry: false }) === undefined ? null : whyNotWritable(target);
  if (why !== null) throw new Error(why);
  replaceFile(target, bytes, () => {});
}

/** What to do when the folder of a new file is missing. */
function missingFolder(path: string, error: unknown): string {
  const folder = dirname(path);
  const isMissing = (error as NodeJS.ErrnoException).code === 'ENOENT' && !existsSync(folder);
  return isMissing ? `; make the folder ${shellPath(folder)} first` : '';
}

function tryTo<T>(path: string, work: () => T): T {
  try {
    return work();
  } catch (error) {
    throw new Failure(`${path}: can't be written: ${systemReason(error)}${missingFolder(path, error)}`);
  }
}
