import { useStore } from 'zustand';
import type { LevelVerdict } from '../../../check/index.ts';
import { type OpenLevel, ofLevel, useEditor } from '../context/index.ts';
import { knownVerdict, limitInWords } from '../proof/index.ts';
import { type CheckWatch, checkedOf, type ProofWatch, watchChecks, watchProofs } from './evidence.ts';

export { problemsKnown } from './evidence.ts';

interface Verdict {
  readonly verdict: LevelVerdict;
  /** What proves it impossible. */
  readonly reason: string | null;
  /** Why the verdict is not certain; null if it is. */
  readonly limit: string | null;
}

/** The verdict of `gq check` on an open level under the terms of the page, as far as it is known now. */
export function useVerdict(level: OpenLevel): Verdict {
  const { checks, proofs } = evidenceOf(useEditor(), level);
  const own = useStore(level.proof.store, (proof) => proof.verdict);
  const limit = useStore(level.proof.store, (proof) => proof.limit);
  const played = useStore(level.proof.store, (proof) => proof.level);
  const terms = useStore(level.proof.store, (proof) => proof.terms);
  const checked = checkedOf({ level: played, terms, limit }, useStore(checks.store));
  const impossible = useStore(proofs.store, (proved) => proved.impossible);
  const verdict = knownVerdict({ verdict: own }, checked, { impossible });
  if (verdict === 'completable') return { verdict, reason: null, limit: null };
  if (impossible !== null) return { verdict, reason: impossible.reason, limit: null };
  if (limit === null || checked?.result != null) return { verdict, reason: null, limit: null };
  const words = checked === null ? limitInWords(limit) : checked.message;
  return { verdict, reason: null, limit: words };
}

/** What workers find out about one open level. */
interface Evidence {
  readonly checks: CheckWatch;
  readonly proofs: ProofWatch;
  close(): void;
}

/** What workers find out about an open level. */
export const evidenceOf = ofLevel(({ desk }, { proof }): Evidence => {
  const proofs = watchProofs({ proof, desk });
  const checks = watchChecks({ proof, desk });
  return {
    checks,
    proofs,
    close() {
      proofs.close();
      checks.close();
    },
  };
});
