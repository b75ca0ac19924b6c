import { Failure, readRegularFile, systemReason } from '../io/index.ts';

/** Files of a project that are read here are small: configuration, workflows, a manifest. Bytes. */
export const LARGEST = 4 * 1024 * 1024;

/**
 * The text of a file of the project; null if there is none.
 * @throws Failure if it can't be read
 */
export function readText(path: string): string | null {
  try {
    return Buffer.from(readRegularFile(path, LARGEST)).toString();
  } catch (error) {
    if (['ENOENT', 'ENOTDIR'].includes((error as NodeJS.ErrnoException).code ?? '')) return null;
    throw new Failure(`${path}: can't be read: ${systemReason(error)}; gq init writes a file here`);
  }
}
