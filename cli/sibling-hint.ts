import { readdirSync } from 'node:fs';
import { basename, dirname } from 'node:path';
import { didYouMean } from './did-you-mean.ts';

/** For a path that doesn't exist: ` (did you mean X?)` if its folder contains a similar name, else an empty text. */
export function siblingHint(path: string): string {
  try {
    return didYouMean(basename(path), readdirSync(dirname(path)));
  } catch {
    return '';
  }
}
