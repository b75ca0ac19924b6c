import writeFileAtomic from 'write-file-atomic';
import { Failure, systemReason } from './failure.ts';

/**
 * Writes a file whole or not at all, and keeps the mode of one that exists.
 * @throws Failure saying why it can't be written
 */
export async function writeWhole(path: string, content: string | Uint8Array): Promise<void> {
  try {
    await writeFileAtomic(path, typeof content === 'string' ? content : Buffer.from(content));
  } catch (error) {
    throw new Failure(`${path}: can't be written: ${systemReason(error)}`);
  }
}
