import { readdirSync } from 'node:fs';
import { basename, dirname } from 'node:path';
import { didYouMean } from './did-you-mean.ts';

/** For a path at which there is nothing: ` (did you mean X?)` when a name beside it is close, else nothing. */
export function siblingHint(path: string): string {
  try {
    return didYouMean(basename(path), readdirSync(dirname(path)));
  } catch {
    return '';
  }
}
