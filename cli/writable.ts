import { accessSync, constants, existsSync, statSync } from 'node:fs';
import { systemReason } from './failure.ts';
import { entryName } from './packs/index.ts';
import { namedPath } from './shown-path.ts';

/** Why an existing file must not be written, for people; null if it may. A read-only file counts as such even for root. */
export function whyNotWritable(path: string): string | null {
  const entry = existsSync(path) ? null : entryName(path);
  if (entry !== null && existsSync(entry.pack)) return `it is in the pack ${namedPath(entry.pack)}: take it out first`;
  try {
    accessSync(path, constants.W_OK);
    const { mode } = statSync(path);
    return (mode & 0o222) === 0 ? `it is read-only (mode ${(mode & 0o777).toString(8).padStart(3, '0')})` : null;
  } catch (error) {
    return systemReason(error);
  }
}
