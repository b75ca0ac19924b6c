import { compareHolds } from '../../../check/runs/index.ts';
import { plural } from '../../../check/words/index.ts';
import type { Hold } from '../../../schema/index.ts';

/** More moved edges than this are counted and not listed. */
const MOST_EDGES = 6;

/** The changes of holds in words: `press 2 is 4 ticks later`, `hold 3 added (130-188)`. */
export function holdsClauses(before: readonly Hold[], after: readonly Hold[]): string[] {
  const { moved, removed, added } = compareHolds(before, after);
  const clauses: string[] = [];
  const by = moved.map((edge) => edge.after - edge.before);
  const isAll = moved.length === 2 * after.length && moved.length > 2 && removed.length + added.length === 0;
  if (isAll && by.every((ticks) => ticks === by[0])) clauses.push(`every press and release is ${shiftInWords(by[0])}`);
  else if (moved.length > MOST_EDGES) {
    const most = Math.max(...by.map(Math.abs));
    clauses.push(`${moved.length} presses and releases moved by up to ${plural(most, 'tick')}`);
  } else {
    for (const { edge, hold, before: b, after: a } of moved) clauses.push(`${edge} ${hold + 1} is ${shiftInWords(a - b)}`);
  }
  const list = (what: string, indices: readonly number[], holds: readonly Hold[]): void => {
    if (indices.length > MOST_EDGES) clauses.push(`${indices.length} holds ${what}`);
    else for (const i of indices) clauses.push(`hold ${i + 1} ${what} (${holds[i][0]}-${holds[i][1]})`);
  };
  list('removed', removed, before);
  list('added', added, after);
  return clauses;
}

const shiftInWords = (ticks: number): string => `${plural(Math.abs(ticks), 'tick')} ${ticks > 0 ? 'later' : 'earlier'}`;
