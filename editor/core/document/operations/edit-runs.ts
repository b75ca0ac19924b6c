import { carryNotes } from '../../../../check/runs/index.ts';
import { joinHolds } from '../../../../engine/index.ts';
import type { Hold, LevelFile } from '../../../../schema/index.ts';
import type { Recipe } from '../edited-level.ts';
import { holdsOf } from './edit-holds.ts';
import { putNotes } from './put-notes.ts';

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
