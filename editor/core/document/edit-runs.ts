import { carryNotes } from '../../../check/runs/index.ts';
import { joinHolds } from '../../../engine/index.ts';
import { type Hold, type LevelFile, notesInOrder, type RunNote, type RunScript } from '../../../schema/index.ts';
import { holdsOf, putNotes } from './edit-holds.ts';
import type { Recipe } from './edited-level.ts';

type RunFile = NonNullable<LevelFile['runs']>[number];

const runsOf = (draft: LevelFile): RunFile[] => draft.runs ?? [];

/** A free name for a run: the wanted one, or one with a number appended. */
export function freeRunName(file: LevelFile, wanted: string): string {
  const taken = new Set(file.runs?.map(({ name }) => name));
  let name = wanted.slice(0, 70);
  for (let i = 2; taken.has(name); i++) name = `${wanted.slice(0, 70)} ${i}`;
  return name;
}

/** Adds a run at the end, or first if it is to be the main run. */
export function addRun(name: string, holds: readonly Hold[], place: 'first' | 'last' = 'last'): Recipe {
  return (draft) => {
    const run = { name, holds: holds.map(([press, release]): [number, number] => [press, release]) };
    draft.runs = place === 'first' ? [run, ...runsOf(draft)] : [...runsOf(draft), run];
  };
}

export function renameRun(name: string, to: string): Recipe {
  return (draft) => {
    const run = runsOf(draft).find((run) => run.name === name);
    if (run !== undefined) run.name = to;
  };
}

export function deleteRun(name: string): Recipe {
  return (draft) => {
    const left = runsOf(draft).filter((run) => run.name !== name);
    if (left.length === 0) delete draft.runs;
    else draft.runs = left;
  };
}

/** Copies a run to a place right after it. @param as name of the copy */
export function duplicateRun(name: string, as: string): Recipe {
  return (draft) => {
    const runs = runsOf(draft);
    const index = runs.findIndex((run) => run.name === name);
    if (index < 0) return;
    const run = runs[index];
    const copy: RunFile = { ...run, name: as, holds: run.holds.map(([press, release]) => [press, release]) };
    if (run.notes !== undefined) copy.notes = run.notes.map((note) => ({ ...note }));
    runs.splice(index + 1, 0, copy);
  };
}

/** Moves a run to another place in the list; pictures show the first. */
export function reorderRun(name: string, index: number): Recipe {
  return (draft) => {
    const runs = runsOf(draft);
    const from = runs.findIndex((run) => run.name === name);
    if (from < 0) return;
    const [run] = runs.splice(from, 1);
    runs.splice(Math.min(runs.length, Math.max(0, index)), 0, run);
  };
}

/** Replaces the holds of a run, by an attempt or a run that a search found. Notes go along with holds that are kept. */
export function replaceHolds(name: string, holds: readonly Hold[]): Recipe {
  return (draft) => {
    const run = runsOf(draft).find((run) => run.name === name);
    if (run === undefined) return;
    if (run.notes !== undefined) putNotes(run, carryNotes(run.notes, holdsOf(draft, name), joinHolds(holds)));
    run.holds = holds.map(([press, release]) => [press, release]);
  };
}

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
