import type { RunNote } from '../basics/index.ts';

/** What ends a line: nothing that a note may have. */
export const LINE_BREAK = /\r\n|[\n\r\v\f\u0085\u2028\u2029]/;

/** The text of a note: one line, without white space at its ends. */
export const NOTE_TEXT = /^[^\s\x85](?:[^\n-\r\x85\u2028\u2029]*[^\s\x85])?$/;

/**
 * Notes in the order of a canonical file: by tick, and those of one tick as they come.
 *
 * @param notes - in any order
 * @returns a new list
 */
export const notesInOrder = <T extends RunNote>(notes: readonly T[]): T[] => [...notes].sort((a, b) => a.tick - b.tick);
