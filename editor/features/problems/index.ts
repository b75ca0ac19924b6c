import { useMemo, useRef } from 'react';
import { useStore } from 'zustand';
import { conflictProblems, type LevelFile, type Problem } from '../../../schema/index.ts';
import { useDocument, useEditor, useLevel, useProofAtRest } from '../../core/context/index.ts';
import { problemsInWords, type SaveState } from '../../core/files/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';
import { evidenceOf, problemsKnown } from '../../core/verdict/index.ts';

/**
 * ms without a change before problems are looked for: that simulates every run at two accuracies at least, too slow during a
 * drag
 */
const REST = 150;

const knownOf = ({ findings, level, terms, limit }: LiveProof) => ({ findings, level, terms, limit });

/** The problems of the level's file on disk; none if it can be read. */
function problemsOfFile(id: string, state: SaveState): readonly Problem[] {
  if (state.kind !== 'deleted' && state.kind !== 'unreadable') return [];
  const file = `${id}.level.json`;
  const [code, message, hint] =
    state.kind === 'deleted'
      ? ['file-deleted', `${file} was deleted or moved on disk`, 'Save it again, or close the level.']
      : [
          'file-unreadable',
          `the file on disk can't be read: ${problemsInWords(file, state.problems)}`,
          'The page shows the last valid state. Fix the file, on disk or as text, or overwrite it with the level on the screen.',
        ];
  return [{ code, severity: 'error', message, hint, pointer: '', line: null, column: null }];
}

/** What a merge left undecided in the level. */
const problemsOfMerge = (file: LevelFile): Problem[] =>
  conflictProblems(file).map((problem) => ({ ...problem, pointer: '', hint: 'Review it, and choose one of the two.' }));

/** The errors and warnings of the level, including what a worker has proved about it; updated once the level rests. */
export function useProblems(): readonly Problem[] {
  const known = useProofAtRest(knownOf, REST);
  const { proofs, checks } = evidenceOf(useEditor(), useLevel());
  const proved = useStore(proofs.store);
  const checked = useStore(checks.store);
  const { opened, document } = useLevel();
  const state = useStore(opened.saver.store);
  const conflicts = useDocument(({ file }) => file.conflicts);
  const last = useRef<readonly Problem[]>([]);
  return useMemo(() => {
    const ofMerge = conflicts === undefined ? [] : problemsOfMerge({ ...document.file(), conflicts });
    const all = [...problemsOfFile(opened.id(), state), ...ofMerge, ...problemsKnown(known, checked, proved)];
    last.current = keepSame(last.current, all);
    return last.current;
  }, [known, proved, checked, opened, document, conflicts, state]);
}

/** The number of problems. */
export const useProblemCount = (): number => useProblems().length;

// problems that are the same as before

const isSame = (a: Problem, b: Problem): boolean =>
  a.code === b.code &&
  a.severity === b.severity &&
  a.message === b.message &&
  a.hint === b.hint &&
  a.pointer === b.pointer &&
  a.line === b.line &&
  a.column === b.column;

const nameOf = ({ code, pointer, message }: Problem): string => `${code} ${pointer} ${message}`;

/**
 * The problems found now, with objects reused for problems that were there before, and the previous list if nothing changed:
 * components for them then need not render again.
 */
export function keepSame(before: readonly Problem[], now: readonly Problem[]): readonly Problem[] {
  const old = new Map(before.map((problem) => [nameOf(problem), problem]));
  const kept = now.map((problem) => {
    const same = old.get(nameOf(problem));
    return same !== undefined && isSame(same, problem) ? same : problem;
  });
  return kept.length === before.length && kept.every((problem, i) => problem === before[i]) ? before : kept;
}

/** A key for each problem, unique in the list and independent of the problems before it. */
export function keysOf(problems: readonly Problem[]): string[] {
  const seen = new Map<string, number>();
  return problems.map(({ code, pointer }) => {
    const name = `${code} ${pointer}`;
    const count = (seen.get(name) ?? 0) + 1;
    seen.set(name, count);
    return `${name} ${count}`;
  });
}
