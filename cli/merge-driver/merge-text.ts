import { tryGit } from '../io/index.ts';

/** The outcome of merging files line by line. */
export type TextMerge = 'clean' | 'conflicts' | 'not merged';

/**
 * Merges text files line by line, as git does on its own, with marks around conflicts.
 * @param into our version, which becomes the result; it is left alone if the files are not text
 */
export function mergeText(base: string, into: string, theirs: string, markerSize: number): TextMerge {
  const labels = ['ours', 'base', 'theirs'].flatMap((label) => ['-L', label]);
  const args = ['merge-file', '-q', `--marker-size=${markerSize}`, ...labels, into, base, theirs];
  const answer = tryGit(args, { folder: '.' });
  const status = answer instanceof Error ? null : answer.status;
  if (status === 0) return 'clean';
  return status !== null && status > 0 && status < 128 ? 'conflicts' : 'not merged';
}
