import { quote } from '../basics/index.ts';

/** What git has left in a text that it could not merge. */
interface MergeMarkers {
  /** Offset of the first marker in the text. */
  readonly offset: number;
  readonly message: string;
  readonly hint: string;
}

/** A line that can only be a marker, for readers that must be small. */
export const MERGE_MARKER = /^(?:<{7}|>{7})/m;

interface Marker {
  readonly offset: number;
  readonly text: string;
  /** What it is made of; a line of = is made of nothing else. */
  readonly sign: string;
}

// git can be told to make them longer
const MARKER = /^(?:(<{7,}|\|{7,}|>{7,})(?:[ \t].*)?|={7,})\r?$/gm;

const allMarkers = (text: string): Marker[] =>
  [...text.matchAll(MARKER)].map((found) => ({ offset: found.index, text: found[0].trimEnd(), sign: found[0][0] }));

const isFirst = (text: string, { offset, sign }: Marker, failure: number): boolean =>
  sign !== '=' || (offset === failure && text.slice(0, offset).trim() !== '');

/**
 * Finds the markers of an unresolved merge in a text that is neither JSON nor XML: in both, a line that begins so is a mistake.
 *
 * @param text - the text
 * @param failure - offset of the mistake for which it can't be read
 * @returns the first marker, and where the others are; null if there is none. A line of `=` alone counts only where the text
 * fails, as it underlines a title elsewhere.
 */
export function mergeMarkers(text: string, failure: number): MergeMarkers | null {
  const all = allMarkers(text);
  const first = all.find((marker) => isFirst(text, marker, failure));
  if (first === undefined) return null;
  const after = all.filter(({ offset }) => offset > first.offset);
  const lineOf = (offset: number): number => text.slice(0, offset).split('\n').length;
  const end = after.find(({ sign }) => sign === '>');
  const to = end === undefined ? '' : `, up to ${quote(end.text)} in line ${lineOf(end.offset)}`;
  const others = after.filter(({ sign }) => sign === '<').length;
  const more = others === 0 ? '' : `; and ${others} more conflict${others === 1 ? '' : 's'}`;
  return {
    offset: first.offset,
    message: `expected a merged file, found an unresolved merge: the marker ${quote(first.text)}${to}${more}`,
    hint: 'Keep one side and delete the markers (<<<<<<<, =======, >>>>>>>), or take a whole side: git checkout --ours or --theirs and the path.',
  };
}

/** A text that stands in a working directory in place of the content of a file. */
interface PointerFile {
  /** What it is, in words: `a Git LFS pointer (12345 bytes are elsewhere)`. */
  readonly found: string;
  /** How to get the content. */
  readonly hint: string;
}

/** `{` */
export const BRACE = 0x7b;

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
  // nearly every file is an object, and no pointer begins like one
  if ((typeof source === 'string' ? source.charCodeAt(0) : source[0]) === BRACE) return null;
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
