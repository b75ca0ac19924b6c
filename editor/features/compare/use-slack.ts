import { useEffect, useState } from 'react';
import type { Hold } from '../../../schema/index.ts';
import type { EdgeSlack } from '../../../solver/index.ts';
import { useEditor, useLevel, useProof } from '../../core/context/index.ts';
import { afterRest } from '../../core/panel/index.ts';

/** ms without a change before it is measured */
const SETTLE = 300;

/** How far each press and release of a run of this level may move alone, measured by a worker; null until it is known. */
export function useSlack(holds: readonly Hold[] | null): readonly EdgeSlack[] | null {
  const { workers } = useEditor();
  const { proof } = useLevel();
  const scene = useProof((now) => now.scene);
  const [known, setKnown] = useState<{
    readonly of: string;
    readonly scene: object;
    readonly slack: readonly EdgeSlack[];
  } | null>(null);
  const key = holds?.join() ?? null;
  // biome-ignore lint/correctness/useExhaustiveDependencies: holds are known by their key
  useEffect(() => {
    if (holds === null || key === null) return;
    let cancel = () => {};
    const forget = afterRest(SETTLE, () => {
      const { level, terms } = proof.proof();
      const job = workers.start('slack', { level: { ...level, runs: [] }, terms, holds, goal: { minerals: 'any' } });
      cancel = job.cancel;
      void job.end.then((end) => {
        if (end.kind === 'done') setKnown({ of: key, scene, slack: end.result });
      });
    });
    return () => {
      forget();
      cancel();
    };
  }, [workers, proof, scene, key]);
  return known !== null && known.of === key && known.scene === scene ? known.slack : null;
}
