import { type Hold, notesInOrder, type RunNote } from '../../schema/index.ts';
import { compareHolds } from './compare-holds.ts';

/**
 * The notes of a run whose holds are replaced. A note at the press or release of a hold that is kept goes along with it; one
 * inside a hold goes along if the whole hold moves; any other stays at its tick. None is dropped.
 * @param before sorted and disjoint
 * @param after likewise
 */
export function carryNotes<T extends RunNote>(notes: readonly T[], before: readonly Hold[], after: readonly Hold[]): T[] {
  if (notes.length === 0) return [];
  const kept = new Map(compareHolds(before, after).pairs.map(([b, a]) => [before[b], after[a]]));
  const carried = (tick: number): number => {
    const hold = before.find(([press, release]) => press <= tick && tick <= release);
    const now = hold === undefined ? undefined : kept.get(hold);
    if (hold === undefined || now === undefined) return tick;
    if (tick === hold[0]) return now[0];
    if (tick === hold[1]) return now[1];
    return now[0] - hold[0] === now[1] - hold[1] ? tick + now[0] - hold[0] : tick;
  };
  return notesInOrder(notes.map((note) => ({ ...note, tick: carried(note.tick) })));
}
