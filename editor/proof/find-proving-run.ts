import { joinHolds } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import type { ShownRun } from './answer.ts';
import type { SceneRecord } from './scene-record.ts';

/**
 * Finds a run that completes the level, or null, and says whether all runs were simulated. The run found last time is tried
 * first.
 */
export function findProvingRun(
  record: SceneRecord,
  level: Level,
  shown: ShownRun,
  last: string | null,
  isLate: () => boolean,
): { readonly name: string | null; readonly isWhole: boolean } {
  if (shown.name !== null && shown.outcome === 'completed') return { name: shown.name, isWhole: true };
  const others = level.runs.filter(({ name }) => name !== shown.name);
  let isWhole = true;
  const completes = (run: { readonly holds: readonly Hold[] }): boolean => {
    const end = isWhole ? record.end(joinHolds(run.holds), isLate) : null;
    isWhole &&= end !== null;
    return end?.outcome === 'completed';
  };
  const again = others.find(({ name }) => name === last);
  if (again !== undefined && others[0] === again && completes(again)) return { name: again.name, isWhole: true };
  const found = others.find(completes)?.name ?? null;
  return { name: found, isWhole: found !== null || isWhole };
}
