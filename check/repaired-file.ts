import { joinHolds } from '../engine/index.ts';
import type { LevelFile } from '../schema/index.ts';
import { applyChange, type Proposal } from '../solver/index.ts';
import { carryNotes } from './runs/index.ts';

/**
 * Makes the content of a level file after a proposal. Nothing else changes: keys of its own (`x-`) and what is left out stay so.
 * @param file the content of the level's file
 * @param proposal a proposal for the level of this file
 * @param runName the name of a run that a search found; no other run of the file may have it
 * @returns the changed copy: a run with other holds stands in its place and
 * keeps its notes, a run that a search found comes after the others
 */
export function repairedFile(file: LevelFile, { change, run, origin }: Proposal, runName: string): LevelFile {
  const changed = change === null ? file : applyChange(file, change);
  if (origin.from === 'own') return changed;
  const holds = run.holds.map(([press, release]): [number, number] => [press, release]);
  const runs = changed.runs ?? [];
  if (origin.from === 'search') return { ...changed, runs: [...runs, { name: runName, holds }] };
  const put = (other: (typeof runs)[number]) => {
    if (other.notes === undefined) return { ...other, holds };
    return { ...other, holds, notes: carryNotes(other.notes, joinHolds(other.holds), holds) };
  };
  return { ...changed, runs: runs.map((other, i) => (i === origin.index ? put(other) : other)) };
}
