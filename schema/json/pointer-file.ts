/** A text that stands in a working directory in place of the content of a file. */
export interface PointerFile {
  /** What it is, in words: `a Git LFS pointer (12345 bytes are elsewhere)`. */
  readonly found: string;
  /** How to get the content. */
  readonly hint: string;
}

/** Pointers of Git LFS and git-annex are shorter, and so are paths. */
const LONGEST = 1024;

/** How a pointer of Git LFS begins. */
export const LFS = /^version https:\/\/(?:git-lfs|hawser)\.github\.com\/spec\/v\d+\s/;
const ANNEX = /^(?:\.\.\/)*(?:\.git|\/)?\/?annex\/objects\/\S+\s*$/;

/** One line without a character that JSON or XML begins with, which ends as the name of a file does. */
const PATH = /^[^\s"'<>{}[\]:,]+\.(?:json|tmj|tmx|gqr|ndjson|tar|tgz|gz|zst)\r?\n?$/;

/** The text of a file that may be a pointer; '' for one that is too long. A pointer is ASCII: other bytes make none of one. */
const textOf = (source: Uint8Array | string): string =>
  source.length > LONGEST ? '' : typeof source === 'string' ? source : String.fromCharCode(...source);

/**
 * Recognizes a text that only says where the content of a file is: of Git LFS, of git-annex, or of a symbolic link that was
 * written as a text.
 *
 * @param source - the bytes of the file, or its text; the first kilobyte of a longer file is enough
 * @returns what it is and what to do; null for anything else
 */
export function pointerFile(source: Uint8Array | string): PointerFile | null {
  const text = textOf(source);
  if (LFS.test(text)) {
    const size = /^size (\d+)\r?$/m.exec(text)?.[1];
    const where = size === undefined ? '' : ` (${size} bytes are elsewhere)`;
    return { found: `a Git LFS pointer${where}`, hint: 'Run git lfs install and git lfs pull, which put the content here.' };
  }
  if (ANNEX.test(text)) return { found: 'a pointer of git-annex', hint: 'Run git annex get with its path.' };
  if (!PATH.test(text)) return null;
  const hint = 'If git wrote it for a symbolic link, set core.symlinks and check it out again; or copy the file here.';
  return { found: 'only a path', hint };
}
