import { quote } from '../basics/index.ts';

/** What git has left in a text that it could not merge. */
export interface MergeMarkers {
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
