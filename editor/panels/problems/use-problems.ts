import { useMemo, useRef } from 'react';
import { useStore } from 'zustand';
import type { Problem } from '../../../schema/index.ts';
import { type LiveProof, withProofs } from '../../proof/index.ts';
import { useRestingProof } from '../parts/index.ts';
import { type Checked, checkedOf, useSolverDesk } from '../solver/index.ts';
import { keepSame } from './kept.ts';

/** ms without a change before problems are looked for: that plays every run at two accuracies at least, which would cost a drag its frames */
const REST = 150;

const knownOf = ({ problems, file, accuracy, limit }: LiveProof) => ({ problems, file, accuracy, limit });

/** Those that a worker found where the page has left something out; where it gave up, too, it says why. */
function foundIn(known: ReturnType<typeof knownOf>, checked: Checked | null): readonly Problem[] {
  const worker = checkedOf(known, checked);
  if (worker === null) return known.problems;
  return worker.result?.problems ?? known.problems.map((problem) => ({ ...problem, message: worker.message }));
}

/** What is wrong with the level and what looks wrong, with what a worker has proved about it; the component follows it once the level rests. */
export function useProblems(): readonly Problem[] {
  const known = useRestingProof(knownOf, REST);
  const { proofs, checks } = useSolverDesk();
  const proved = useStore(proofs.store);
  const checked = useStore(checks.store);
  const last = useRef<readonly Problem[]>([]);
  return useMemo(() => {
    last.current = keepSame(last.current, withProofs(foundIn(known, checked), proved));
    return last.current;
  }, [known, proved, checked]);
}

/** How many problems there are. */
export const useProblemCount = (): number => useProblems().length;
