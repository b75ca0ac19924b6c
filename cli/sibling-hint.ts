import { lstatSync, readdirSync, readlinkSync } from 'node:fs';
import { basename, dirname } from 'node:path';
import { closestName } from '../schema/index.ts';

/** The part of a name that tells level files apart: `.level.json` at the end of both would make any two names look close. */
const stemOf = (name: string): string => name.replace(/(?:\.level)?\.[^.]+$/, '');

/**
 * For a path at which there is nothing: what a symbolic link there points to, or ` (did you mean X?)` when a name beside
 * it is close, else nothing.
 */
export function siblingHint(path: string): string {
  try {
    if (lstatSync(path, { throwIfNoEntry: false })?.isSymbolicLink() === true)
      return `; it is a symbolic link to ${readlinkSync(path)}, which leads nowhere`;
    const names = readdirSync(dirname(path));
    const stem = closestName(stemOf(basename(path)), names.map(stemOf));
    const same = names.filter((name) => stemOf(name) === stem);
    const best = closestName(basename(path), same) ?? same.find((name) => name.endsWith('.level.json')) ?? same[0];
    return best === undefined ? '' : ` (did you mean ${best}?)`;
  } catch {
    return '';
  }
}
