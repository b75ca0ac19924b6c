import { useEffect, useMemo, useState } from 'react';
import { useStore } from 'zustand';
import { ACCURACIES, type AccuracyName } from '../../../engine/index.ts';
import { question } from '../../core/ask/index.ts';
import { useEditor, useLevel } from '../../core/context/index.ts';
import { isWhole, type LiveProof, type ProofStore, withoutRuns } from '../../core/proof/index.ts';
import { jobs, type Setting, type SettingError } from '../../workers/index.ts';

/** in display order */
export const NAMES = Object.keys(ACCURACIES) as readonly AccuracyName[];

/** ms without a change before a run is compared again */
const REST = 200;

/** How the shown run goes at every named setting, and what each costs. */
export const namedQuestion = question({
  job: jobs.accuracy,
  request(known: LiveProof) {
    const { level, terms, run } = known;
    return isWhole(known) ? { level: withoutRuns(level), terms, holds: run.holds, methods: 'named' as const } : null;
  },
  follows: {
    wait: { rest: REST },
    of: (proof: ProofStore): LiveProof => proof.proof(),
    same: (asked, now) =>
      asked.scene === now.scene && isWhole(asked) === isWhole(now) && asked.run.holds.join() === now.run.holds.join(),
    on: (proof) => [proof.store.subscribe],
  },
});

interface NamedResults {
  /** Without costs until these are measured. */
  readonly settings: readonly (SettingError & Partial<Pick<Setting, 'cost'>>)[];
  readonly knownTo: number | null;
  readonly doubt: string | null;
}

interface ShownResults extends NamedResults {
  /** Whether they belong to the present run. */
  readonly isFresh: boolean;
}

/** The named settings on the shown run; what was known before stays until something newer is. */
export function useNamedResults(): ShownResults {
  const { desk } = useEditor();
  const { proof } = useLevel();
  const asked = useMemo(() => namedQuestion(desk, proof), [desk, proof]);
  useEffect(() => asked.close, [asked]);
  const { answer, progress, phase } = useStore(asked.store);
  const known: NamedResults | null = answer ?? progress;
  const [last, setLast] = useState<NamedResults>({ settings: [], knownTo: null, doubt: null });
  useEffect(() => {
    if (known !== null) setLast(known);
  }, [known]);
  return { ...(known ?? last), isFresh: known !== null || phase === 'nothing' || phase === 'failed' };
}
