import { accessSync, constants, statSync } from 'node:fs';
import { systemReason } from './failure.ts';

/** Why a file that is there is not to be written, for people; null when it may be. What is read-only stays so for an administrator, too, who could write it. */
export function whyNotWritable(path: string): string | null {
  try {
    accessSync(path, constants.W_OK);
    const { mode } = statSync(path);
    return (mode & 0o222) === 0 ? `it is read-only (mode ${(mode & 0o777).toString(8).padStart(3, '0')})` : null;
  } catch (error) {
    return systemReason(error);
  }
}
