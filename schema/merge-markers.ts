import { quote } from './format-value.ts';

/** What git has left in a text that it could not merge. */
export interface MergeMarkers {
  /** Offset of the first marker in the text. */
  readonly offset: number;
  readonly message: string;
  readonly hint: string;
}

// git can be told to make them longer
const MARKER = /^(?:(<{7,}|\|{7,}|>{7,})(?:[ \t].*)?|={7,})\r?$/gm;

/**
 * Finds the markers of an unresolved merge in a text that is neither JSON nor XML: in both, a line that begins so is a mistake.
 *
 * @param text - the text
 * @param failure - offset of the mistake for which it can't be read
 * @returns the first marker, and where the others are; null if there is none. A line of `=` alone counts only where the text
 * fails, as it underlines a title elsewhere.
 */
export function mergeMarkers(text: string, failure: number): MergeMarkers | null {
  const all = [...text.matchAll(MARKER)].map(({ 0: whole, 1: sign, index }) => ({ whole: whole.trimEnd(), sign, index }));
  const first = all.find(({ sign, index }) => sign !== undefined || (index === failure && text.slice(0, index).trim() !== ''));
  if (first === undefined) return null;
  const lineOf = (index: number): number => text.slice(0, index).split('\n').length;
  const end = all.find(({ sign, index }) => index > first.index && sign?.[0] === '>');
  const to = end === undefined ? '' : `, up to ${quote(end.whole)} in line ${lineOf(end.index)}`;
  const others = all.filter(({ sign, index }) => index > first.index && sign?.[0] === '<').length;
  const more = others === 0 ? '' : `; and ${others} more conflict${others === 1 ? '' : 's'}`;
  return {
    offset: first.index,
    message: `expected a merged file, found an unresolved merge: the marker ${quote(first.whole)}${to}${more}`,
    hint: 'Keep one side and delete the markers (<<<<<<<, =======, >>>>>>>), or take a whole side: git checkout --ours or --theirs and the path.',
  };
}
