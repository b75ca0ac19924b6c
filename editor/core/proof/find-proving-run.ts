import type { RunFindings } from '../../../check/index.ts';
import type { RunEnd } from '../../../check/words/index.ts';
import { joinHolds, WorkBudget } from '../../../engine/index.ts';
import type { Level } from '../../../schema/index.ts';
import type { ShownRun } from './answer.ts';
import { MOST_WORK } from './patience.ts';
import type { SceneRecord } from './scene-record.ts';

/** What the runs of a level show. */
interface Proving {
  /** A run that completes the level; null if none is known. */
  readonly name: string | null;
  /** How runs end, as far as the verdict needs it; those that were not simulated to their end are stopped. */
  readonly ends: RunFindings['ends'];
}

/** How a run ends. @param end null: it was stopped */
const endAs = ({ name }: Level['runs'][number], end: RunEnd | null): RunFindings['ends'][number] => ({
  ...(end ?? { outcome: 'timeout', with: null, time: 0, tick: 0 }),
  name,
  isStopped: end === null,
});

/**
 * Finds a run that completes the level: the shown one if possible, else the first. As in a check, the runs share the work that the
 * level may cost, in their order: a run counts if it and those before it do not exceed that.
 * @param shown the shown run, what it costs, and whether it was stopped: then nothing more is simulated
 */
export function findProvingRun(
  record: SceneRecord,
  { runs }: Level,
  shown: ShownRun & { readonly looks: number; readonly isCut: boolean },
  isLate: () => boolean,
): Proving {
  const { maxWork } = record.terms;
  const { most } = new WorkBudget(maxWork);
  /** How run `i` ends; null: it was not simulated to its end. */
  const endOf = (i: number) =>
    shown.isCut ? null : runs[i].name === shown.name ? shown : record.end(joinHolds(runs[i].holds), isLate);
  /** Whether the runs up to the `i`-th cost no more than allowed. So few that the page simulates them cannot. */
  const isPaidFor = (i: number): boolean => {
    let looks = 0;
    if (maxWork < MOST_WORK * (i + 1)) for (let k = 0; k <= i; k++) looks += endOf(k)?.looks ?? Number.POSITIVE_INFINITY;
    return looks <= most;
  };
  const own = runs.findIndex(({ name }) => name === shown.name);
  if (own >= 0 && endOf(own)?.outcome === 'completed' && isPaidFor(own))
    return { name: runs[own].name, ends: [endAs(runs[own], shown)] };
  const ends: RunFindings['ends'][number][] = [];
  for (const [i, run] of runs.entries()) {
    const end = isPaidFor(i) ? endOf(i) : null;
    ends.push(endAs(run, end));
    if (end === null) break;
    if (end.outcome === 'completed') return { name: run.name, ends };
  }
  return { name: null, ends };
}
