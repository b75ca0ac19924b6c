import { isSame, LIMITS, notesInOrder, type RunNote } from '../../schema/index.ts';
import { namedNotes } from '../notes.ts';

/**
 * Merges the notes of a run, note by note: each side's additions and removals are taken. A note that is moved or reworded counts
 * as removed and added, so what both sides make of one note stays twice and nothing is lost.
 * @returns null where one side's list stands as it is, or both together have more notes than a run can have
 */
export function mergeNotes(bases: readonly unknown[], mine: unknown, theirs: unknown): { readonly notes: unknown } | null {
  const isWhole = isSame(mine, theirs) || bases.some((base) => isSame(base, theirs)) || bases.every((base) => isSame(base, mine));
  if (isWhole) return null;
  const [m, t, ...b] = [mine, theirs, ...bases].map((list) => namedNotes((list ?? []) as readonly RunNote[]));
  const isKept = (name: string): boolean => {
    const [here, there] = [m.has(name), t.has(name)];
    // a side that differs from the base has changed it
    return here === there || b.some((notes) => notes.has(name) === there) ? here : there;
  };
  const before = b[0] ?? new Map<string, RunNote>();
  const fresh = [...new Set([...m.keys(), ...t.keys()])].filter((name) => !before.has(name)).sort();
  const kept = [...before.keys(), ...fresh].filter(isKept);
  const notes = notesInOrder(kept.map((name) => (before.get(name) ?? m.get(name) ?? t.get(name)) as RunNote));
  if (notes.length > LIMITS.notes) return null;
  const isLeftOut = notes.length === 0 && (mine === undefined || theirs === undefined);
  return { notes: isLeftOut ? undefined : notes };
}
