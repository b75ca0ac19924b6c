import { useStore } from 'zustand';
import { useLevel, useProof } from '../../core/context/index.ts';
import type { Loss } from '../../workers/index.ts';
import { accuracyNameOf } from '../../workers/index.ts';
import { lossKey, lostOf } from './lost-store.ts';

/** Since when the shown run is lost; null if it completes the level or nothing is known. */
export function useRunLoss(): Loss | null {
  const losses = useStore(lostOf(useLevel()), (state) => state.losses);
  const key = useProof(({ run, terms }) => (run.outcome === 'completed' ? null : lossKey(run.holds, accuracyNameOf(terms))));
  return key === null ? null : (losses.get(key) ?? null);
}
