import { useMemo, useRef } from 'react';
import { useStore } from 'zustand';
import type { Problem } from '../../../schema/index.ts';
import { useLevel } from '../../context/index.ts';
import { problemsInWords, type SaveState } from '../../files/index.ts';
import { type LiveProof, toldProblems } from '../../proof/index.ts';
import { useDebouncedProof } from '../parts/index.ts';
import { checkedOf, useSolverSession } from '../solver/index.ts';
import { keepSame } from './kept.ts';

/** ms without a change before problems are looked for: that plays every run at two accuracies at least, which would cost a drag its frames */
const REST = 150;

const knownOf = ({ findings, level, accuracy, limit }: LiveProof) => ({ findings, level, accuracy, limit });

/** What is wrong with the file of the level, as it is on the disk; nothing where it can be read. */
function problemsOfFile(id: string, state: SaveState): readonly Problem[] {
  if (state.kind !== 'deleted' && state.kind !== 'unreadable') return [];
  const file = `${id}.level.json`;
  const [code, message, hint] =
    state.kind === 'deleted'
      ? ['file-deleted', `${file} was deleted or moved on the disk`, 'Write it again, or let it go.']
      : [
          'file-unreadable',
          `the file on the disk can't be read: ${problemsInWords(file, state.problems)}`,
          'What is on the screen is the last good state. Mend the file, where it is or as text, or write what is on the screen over it.',
        ];
  return [{ code, severity: 'error', message, hint, pointer: '', line: null, column: null }];
}

/** What is wrong with the level and what looks wrong, with what a worker has proved about it; the component follows it once the level rests. */
export function useProblems(): readonly Problem[] {
  const known = useDebouncedProof(knownOf, REST);
  const { proofs, checks } = useSolverSession();
  const proved = useStore(proofs.store);
  const checked = useStore(checks.store);
  const { opened } = useLevel();
  const state = useStore(opened.saver.store);
  const last = useRef<readonly Problem[]>([]);
  return useMemo(() => {
    const all = [...problemsOfFile(opened.id(), state), ...toldProblems(known, checkedOf(known, checked), proved)];
    last.current = keepSame(last.current, all);
    return last.current;
  }, [known, proved, checked, opened, state]);
}

/** How many problems there are. */
export const useProblemCount = (): number => useProblems().length;
