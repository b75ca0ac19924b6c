import { useMemo } from 'react';
import type { Hold } from '../../schema/index.ts';
import type { EdgeSlack } from '../../solver/index.ts';
import { useQuestion } from '../ask/index.ts';
import { useEditor, useLevel, useProof } from '../context/index.ts';
import { type SlackOf, slackQuestion } from '../proof/index.ts';

/** How far each press and release of a run of this level may move alone, measured by a worker; null until it is known. */
export function useSlack(holds: readonly Hold[] | null): readonly EdgeSlack[] | null {
  const { desk } = useEditor();
  const { proof } = useLevel();
  const scene = useProof((now) => now.scene);
  const key = holds?.join() ?? null;
  // biome-ignore lint/correctness/useExhaustiveDependencies: holds are known by their key
  const of = useMemo((): SlackOf | null => {
    const { level, terms } = proof.proof();
    return holds === null ? null : { of: scene, level, terms, holds, goal: { minerals: 'any' } };
  }, [proof, scene, key]);
  const asked = useQuestion(slackQuestion, desk, of);
  return asked !== null && asked.of === of ? asked.answer : null;
}
