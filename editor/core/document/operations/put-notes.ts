import { type LevelFile, notesInOrder, type RunNote } from '../../../../schema/index.ts';

type RunFile = NonNullable<LevelFile['runs']>[number];

/** Gives a run of a draft its notes, sorted; without any, it has no list. */
export function putNotes(run: RunFile, notes: readonly RunNote[]): void {
  if (notes.length === 0) delete run.notes;
  else run.notes = notesInOrder(notes);
}
