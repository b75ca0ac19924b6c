import { relative, resolve, sep } from 'node:path';
import type { Configuration } from './configuration.ts';

/** Finds the pattern of a configuration that leaves a file out; null if none does. */
export type Ignore = (file: string) => string | null;

interface Pattern {
  readonly text: string;
  /** Whether it takes files back in that an earlier pattern leaves out. */
  readonly isNegated: boolean;
  readonly onlyDirectories: boolean;
  readonly matches: (path: string) => boolean;
}

/**
 * The patterns of a configuration, as in .gitignore: without a slash they match a name at any depth, with one a path from the
 * directory of the configuration; a directory stands for everything below it; `!` takes back; the last pattern that matches
 * decides. Other than there, a file below a directory that is left out can be taken back.
 */
export async function ignoreOf({ directory, ignore }: Pick<Configuration, 'directory' | 'ignore'>): Promise<Ignore> {
  if (ignore.length === 0) return () => null;
  // only a configuration with patterns pays for it
  const { default: picomatch } = await import('picomatch');
  const patterns = ignore.map((text): Pattern => {
    const isNegated = text.startsWith('!');
    const body = text.slice(isNegated ? 1 : 0).replace(/^(?:\.\/)+/, '');
    const onlyDirectories = body.endsWith('/');
    const plain = body.replace(/\/+$/, '').replace(/^\/+/, '');
    const glob = body.replace(/\/+$/, '').includes('/') ? plain : `**/${plain}`;
    const isMatch = picomatch(glob, { dot: true, nonegate: true });
    return { text, isNegated, onlyDirectories, matches: (path) => isMatch(path) };
  });
  return (file) => {
    const path = relative(directory, resolve(file)).split(sep).join('/');
    const steps = path.split('/');
    const directories = steps.slice(1).map((_, i) => steps.slice(0, i + 1).join('/'));
    let last: Pattern | null = null;
    for (const pattern of patterns) {
      if (directories.some((one) => pattern.matches(one)) || (!pattern.onlyDirectories && pattern.matches(path))) last = pattern;
    }
    return last === null || last.isNegated ? null : last.text;
  };
}
