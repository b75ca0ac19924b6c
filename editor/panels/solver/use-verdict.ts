import { useStore } from 'zustand';
import { type OpenLevel, useEditor } from '../../context/index.ts';
import type { LiveProof } from '../../proof/index.ts';
import { solverDeskOf } from './desk.ts';

/** The verdict of `gq check` on an open level, as far as it is known by now, and what proves it impossible. */
export function useVerdict(level: OpenLevel): { verdict: LiveProof['verdict'] | 'impossible'; reason: string | null } {
  const verdict = useStore(level.proof.store, (proof) => proof.verdict);
  const proof = useStore(solverDeskOf(useEditor(), level).proofs.store, ({ impossible }) => impossible);
  if (verdict === 'completable' || proof === null) return { verdict, reason: null };
  return { verdict: 'impossible', reason: proof.reason };
}
