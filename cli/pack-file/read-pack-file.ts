import { MAX_FILE_SIZE, type PackReading, readPack } from '../../schema/index.ts';
import { systemReason } from '../failure.ts';
import { NotAFile, readRegularFile } from '../regular-file.ts';

/** A pack file that was read, or why it could not be read. */
export type PackOnDisk = { readonly reading: PackReading } | { readonly unreadable: string };

export function readPackFile(file: string): PackOnDisk {
  try {
    return { reading: readPack(readRegularFile(file, MAX_FILE_SIZE)) };
  } catch (error) {
    return { unreadable: `can't be read: ${error instanceof NotAFile ? error.message : systemReason(error)}` };
  }
}
