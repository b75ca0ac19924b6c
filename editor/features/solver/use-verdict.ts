import { useStore } from 'zustand';
import type { LevelVerdict } from '../../../check/index.ts';
import { type OpenLevel, useEditor } from '../../core/context/index.ts';
import { limitInWords, toldVerdict } from '../../core/proof/index.ts';
import { checkedOf } from './check-watch.ts';
import { solverSessionOf } from './solver-session.ts';

interface Verdict {
  readonly verdict: LevelVerdict;
  /** What proves it impossible. */
  readonly reason: string | null;
  /** Why the verdict is not certain; null if it is. */
  readonly limit: string | null;
}

/** The verdict of `gq check` on an open level under the terms of the page, as far as it is known now. */
export function useVerdict(level: OpenLevel): Verdict {
  const solver = solverSessionOf(useEditor(), level);
  const own = useStore(level.proof.store, (proof) => proof.verdict);
  const limit = useStore(level.proof.store, (proof) => proof.limit);
  const played = useStore(level.proof.store, (proof) => proof.level);
  const terms = useStore(level.proof.store, (proof) => proof.terms);
  const checked = checkedOf({ level: played, terms, limit }, useStore(solver.checks.store));
  const impossible = useStore(solver.proofs.store, (proved) => proved.impossible);
  const verdict = toldVerdict({ verdict: own }, checked, { impossible });
  if (verdict === 'completable') return { verdict, reason: null, limit: null };
  if (impossible !== null) return { verdict, reason: impossible.reason, limit: null };
  if (limit === null || checked?.result != null) return { verdict, reason: null, limit: null };
  const words = checked === null ? limitInWords(limit) : checked.message;
  return { verdict, reason: null, limit: words };
}
