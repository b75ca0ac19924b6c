import { existsSync, lstatSync, readdirSync, readlinkSync } from 'node:fs';
import { basename, dirname } from 'node:path';
import { closestName } from '../schema/basics/index.ts';

/** The part of a name that tells level files apart: `.level.json` at the end of both would make any two names look close. */
const stemOf = (name: string): string => name.replace(/(?:\.level)?\.[^.]+$/, '');

/**
 * For a path at which there is nothing: where a symbolic link at it or above it points to, or ` (did you mean X?)` when a name beside
 * it is close, else nothing.
 */
export function siblingHint(path: string): string {
  try {
    const broken = brokenLinkOn(path);
    if (broken !== null)
      return `; ${broken === path ? 'it' : broken} is a symbolic link to ${readlinkSync(broken)}, which leads nowhere`;
    const names = readdirSync(dirname(path));
    const stem = closestName(stemOf(basename(path)), names.map(stemOf));
    const same = names.filter((name) => stemOf(name) === stem);
    const best = closestName(basename(path), same) ?? same.find((name) => name.endsWith('.level.json')) ?? same[0];
    return best === undefined ? '' : ` (did you mean ${best}?)`;
  } catch {
    return '';
  }
}

/** The symbolic link on the way to a path that leads nowhere: the path itself or a folder of it; null if there is none. */
function brokenLinkOn(path: string): string | null {
  for (let at = path; ; at = dirname(at)) {
    const stats = lstatSync(at, { throwIfNoEntry: false });
    if (stats?.isSymbolicLink() === true && !existsSync(at)) return at;
    if (stats !== undefined || dirname(at) === at) return null;
  }
}
