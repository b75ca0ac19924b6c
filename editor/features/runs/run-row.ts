import { outcomeAsPredicate } from '../../../check/words/index.ts';
import type { TreeRow } from '../../core/tree/index.ts';
import type { RunSummary } from './run-ends.ts';

/** A run as the list shows it. */
export interface RunRow extends TreeRow {
  readonly holds: number;
  /** null if it is not simulated yet */
  readonly summary: RunSummary | null;
}

interface RunInList {
  readonly name: string;
  readonly holds: readonly unknown[];
}

/** @param range of the level, px */
export function runRows(runs: readonly RunInList[], endOf: (name: string) => RunSummary | null, range: number): RunRow[] {
  return runs.map(({ name, holds }, place) => {
    const summary = endOf(name);
    const how = summary === null ? 'not simulated yet' : outcomeAsPredicate(summary, range);
    return {
      key: name,
      depth: 1,
      label: `${name}, ${how}`,
      expanded: null,
      list: 'runs',
      place,
      siblings: runs.length,
      holds: holds.length,
      summary,
    };
  });
}
