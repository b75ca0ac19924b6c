import { useMemo, useRef } from 'react';
import { useStore } from 'zustand';
import type { Problem } from '../../../schema/index.ts';
import { type LiveProof, withProofs } from '../../proof/index.ts';
import { useRestingProof } from '../parts/index.ts';
import { useSolverDesk } from '../solver/index.ts';
import { keepSame } from './kept.ts';

/** ms without a change before problems are looked for: that plays every run at two accuracies at least, which would cost a drag its frames */
const REST = 150;

const problemsOf = (proof: LiveProof): readonly Problem[] => proof.problems;

/** What is wrong with the level and what looks wrong, with what a worker has proved about it; the component follows it once the level rests. */
export function useProblems(): readonly Problem[] {
  const known = useRestingProof(problemsOf, REST);
  const proved = useStore(useSolverDesk().proofs.store);
  const last = useRef<readonly Problem[]>([]);
  return useMemo(() => {
    last.current = keepSame(last.current, withProofs(known, proved));
    return last.current;
  }, [known, proved]);
}

/** How many problems there are. */
export const useProblemCount = (): number => useProblems().length;
