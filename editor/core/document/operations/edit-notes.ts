import { type LevelFile, notesInOrder, type RunNote, type RunScript } from '../../../../schema/index.ts';
import type { Recipe } from '../edited-level.ts';
import { putNotes } from './put-notes.ts';

type RunFile = NonNullable<LevelFile['runs']>[number];

const runOf = (file: LevelFile, run: string): RunFile | undefined => file.runs?.find(({ name }) => name === run);

/** The notes of a run, sorted by tick. All indices of notes refer to these. */
export const notesOf = (file: LevelFile, run: string): RunNote[] => notesInOrder(runOf(file, run)?.notes ?? []);

function onNotes(run: string, change: (notes: RunNote[]) => readonly RunNote[]): Recipe {
  return (draft) => {
    const found = runOf(draft, run);
    // copies, as a draft may not stand at two places
    if (found !== undefined) putNotes(found, change(notesOf(draft, run).map((note) => ({ ...note }))));
  };
}

/** Adds a note after those of its tick. */
export const addNote = (run: string, tick: number, text: string): Recipe => onNotes(run, (notes) => [...notes, { tick, text }]);

/** Changes what a note says. An empty text deletes it. */
export const rewordNote = (run: string, index: number, text: string): Recipe =>
  onNotes(run, (notes) => notes.flatMap((note, i) => (i !== index ? [note] : text.trim() === '' ? [] : [{ ...note, text }])));

/** Moves a note to another tick. */
export const moveNote = (run: string, index: number, tick: number): Recipe =>
  onNotes(run, (notes) => notes.map((note, i) => (i === index ? { ...note, tick } : note)));

export const deleteNote = (run: string, index: number): Recipe => onNotes(run, (notes) => notes.filter((_, i) => i !== index));

/** Replaces holds and notes of a run by what its text says. Notes that say the same keep keys that a text does not show. */
export function writeScript(run: string, { holds, notes }: RunScript): Recipe {
  return (draft) => {
    const found = runOf(draft, run);
    if (found === undefined) return;
    const old = notesOf(draft, run).map((note) => ({ ...note }));
    const take = (is: (note: RunNote) => boolean): RunNote | undefined => {
      const index = old.findIndex(is);
      return index < 0 ? undefined : old.splice(index, 1)[0];
    };
    const exact = notes.map(({ tick, text }) => take((note) => note.tick === tick && note.text === text));
    const written = notes.map((note, i) => ({ ...(exact[i] ?? take(({ text }) => text === note.text)), ...note }));
    found.holds = holds.map(([press, release]) => [press, release]);
    putNotes(found, written);
  };
}
