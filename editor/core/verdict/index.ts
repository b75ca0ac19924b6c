import { useStore } from 'zustand';
import { createStore, type StoreApi } from 'zustand/vanilla';
import type { LevelVerdict } from '../../../check/index.ts';
import type { Problem } from '../../../schema/index.ts';
import { type AskedOf, jobs, type Proofs } from '../../workers/index.ts';
import { type Asked, type Desk, question } from '../ask/index.ts';
import { type OpenLevel, ofLevel, useEditor } from '../context/index.ts';
import {
  type FoundByWorker,
  type LiveProof,
  limitInWords,
  type ProofStore,
  type Proved,
  toldProblems,
  toldVerdict,
  toPlay,
  toProve,
} from '../proof/index.ts';

// What is true of the open level: what the page finds itself, together with what workers find once the level rests.

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
  const verdict = toldVerdict({ verdict: own }, checked, { impossible });
  if (verdict === 'completable') return { verdict, reason: null, limit: null };
  if (impossible !== null) return { verdict, reason: impossible.reason, limit: null };
  if (limit === null || checked?.result != null) return { verdict, reason: null, limit: null };
  const words = checked === null ? limitInWords(limit) : checked.message;
  return { verdict, reason: null, limit: words };
}

/** The problems of a level as far as they are known; `line` and `column` are null. */
export const problemsKnown = (
  known: Pick<LiveProof, 'findings' | 'level' | 'terms' | 'limit'>,
  checked: Checked | null,
  proved: Proved,
): readonly Problem[] => toldProblems(known, checkedOf(known, checked), proved);

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

// runs that the page does not simulate itself

/** What a worker found out about a level that the page does not simulate itself. */
interface Checked extends FoundByWorker, AskedOf<typeof jobs.check> {}

interface CheckWatch {
  /** null: nothing is known */
  readonly store: StoreApi<Checked | null>;
  close(): void;
}

/** All runs of a level of which the page has left something out. Before that, the page itself tries with a larger limit. */
export const checkQuestion = question({
  job: jobs.check,
  request: (of: AskedOf<typeof jobs.check>) => of,
  follows: {
    wait: { rest: 700 },
    of: (proof: ProofStore) => toPlay(proof.proof()),
    same: (asked, now) => asked.level === now.level && asked.terms === now.terms,
    on: (proof) => [proof.store.subscribe],
  },
});

/** Follows the level: if the page has left something out, a worker simulates all of it once the level rests. */
function watchChecks({ proof, desk }: { readonly proof: ProofStore; readonly desk: Desk }): CheckWatch {
  const store = createStore<Checked | null>(() => null);
  const checks = checkQuestion(desk, proof);
  checks.store.subscribe(({ phase, of, answer, message }) => {
    if (of !== null && (phase === 'done' || phase === 'failed'))
      store.setState({ ...of, result: answer, message: message ?? '' }, true);
  });
  return { store, close: checks.close };
}

/** The worker's result for the level as it is; null if the page left nothing out or the worker is not done. */
const checkedOf = (proof: Pick<LiveProof, 'level' | 'terms' | 'limit'>, checked: Checked | null): Checked | null =>
  proof.limit !== null && checked !== null && checked.level === proof.level && checked.terms === proof.terms ? checked : null;

// proofs that something is out of reach

interface ProofWatch {
  /** What is proved about the current level; empty while not known. */
  readonly store: StoreApi<Proved>;
  close(): void;
}

const NOTHING: Proved = { impossible: null, minerals: [], gaveUp: null };

/**
 * What no run reaches, the black hole or a mineral. What a run of the level reaches is not searched for a proof. It waits for the
 * robustness, which matters to the user more often.
 */
export const proofQuestion = question({
  job: jobs.proofs,
  request: toProve,
  follows: {
    wait: { rest: 500 },
    of: (proof: ProofStore): LiveProof => proof.proof(),
    // runs may come and go: a proof holds for all of them
    same: (asked, now) => asked.scene === now.scene,
    on: (proof) => [proof.store.subscribe],
  },
});

function provedBy({ phase, progress, answer, message, gaveUp }: Asked<LiveProof, Proofs, Proofs>): Proved {
  // everything is reached, so there is nothing to prove
  if (phase === 'nothing') return { ...NOTHING, isWhole: true };
  if (answer !== null) return { ...answer, gaveUp: null, isWhole: true };
  const soFar = progress === null ? NOTHING : { ...progress, gaveUp: null };
  return gaveUp ? { ...soFar, gaveUp: message } : soFar;
}

/** Follows the level: once it rests, tries to prove that the black hole or a mineral is out of reach. */
export function watchProofs({ proof, desk }: { readonly proof: ProofStore; readonly desk: Desk }): ProofWatch {
  const proofs = proofQuestion(desk, proof);
  const store = createStore<Proved>(() => provedBy(proofs.store.getState()));
  proofs.store.subscribe((now) => {
    const proved = provedBy(now);
    if (proved !== store.getState()) store.setState(proved, true);
  });
  return { store, close: proofs.close };
}
