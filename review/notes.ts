import { notesInOrder, type RunNote } from '../schema/index.ts';

/** Notes as a canonical file has them: sorted by tick, with their keys in order. */
export const canonicalNotes = (notes: readonly RunNote[]): RunNote[] =>
  notesInOrder(notes).map(({ tick, text, ...others }) => ({ tick, text, ...others }));

/** Notes with names by which versions of a list can be compared: two that say the same at the same tick have different ones. */
export function namedNotes(notes: readonly RunNote[]): Map<string, RunNote> {
  const named = new Map<string, RunNote>();
  const counts = new Map<string, number>();
  for (const note of canonicalNotes(notes)) {
    const content = JSON.stringify(note);
    const count = (counts.get(content) ?? 0) + 1;
    counts.set(content, count);
    named.set(`${content}${count}`, note);
  }
  return named;
}
