import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Failure, onSignal, systemReason } from '../io/index.ts';

/** A folder for what is too large for memory. */
export interface Scratch {
  readonly folder: string;
  /** Removes it; a signal that ends the process does so, too. */
  readonly remove: () => void;
}

/** @throws Failure if there is no place for temporary files */
export function openScratch(): Scratch {
  let folder: string;
  try {
    folder = mkdtempSync(join(tmpdir(), 'gq-'));
  } catch (error) {
    throw new Failure(`${tmpdir()}: temporary files can't be written there: ${systemReason(error)}; TMPDIR names another folder`);
  }
  const removeFolder = (): void => rmSync(folder, { recursive: true, force: true });
  const forget = onSignal(removeFolder);
  return {
    folder,
    remove() {
      forget();
      removeFolder();
    },
  };
}
