import { useEffect } from 'react';
import type { Command } from '../../core/commands/index.ts';
import { useEditor, useLevel } from '../../core/context/index.ts';
import { useSolverSession } from './use-solver-session.ts';

/** Starts a search. */
export const SOLVE_KEY = '$mod+Enter';

/**
 * Renders nothing. Registers the commands of the solver and keeps the robustness of the shown run up to date, whichever panel
 * is open.
 */
export function SolverWatch() {
  const { commands } = useEditor();
  const { proof } = useLevel();
  const { search, difficulty } = useSolverSession();
  useEffect(() => {
    const best = () => search.store.getState().found.find(({ works }) => works);
    const needsFound = () => (best() === undefined ? 'solve first: no run has been found yet' : null);
    const list: readonly Command[] = [
      {
        id: 'solve.start',
        title: 'Solve: find runs',
        group: 'Solve',
        keys: [SOLVE_KEY],
        inText: true,
        run: () => {
          search.start();
          commands.run('panel.solver');
        },
      },
      {
        id: 'solve.cancel',
        title: 'Stop the search',
        group: 'Solve',
        needs: () => (search.store.getState().phase === 'running' ? null : 'no search is running'),
        run: search.cancel,
      },
      {
        id: 'solve.use',
        title: 'Add the best run found',
        group: 'Solve',
        needs: needsFound,
        run: () => {
          const found = best();
          if (found !== undefined) search.use(found.candidate.holds);
        },
      },
      {
        id: 'solve.replace',
        title: 'Replace the shown run with the best run found',
        group: 'Solve',
        needs: () => needsFound() ?? (proof.proof().run.name === null ? 'show a run first' : null),
        run: () => {
          const found = best();
          if (found !== undefined) search.use(found.candidate.holds, proof.proof().run.name ?? undefined);
        },
      },
      {
        id: 'solve.clear',
        title: 'Discard the search results',
        group: 'Solve',
        needs: () => (search.store.getState().phase === 'idle' ? 'solve first' : null),
        run: search.clear,
      },
      {
        id: 'solve.difficulty',
        title: 'Measure the difficulty',
        group: 'Solve',
        run: () => {
          difficulty.start();
          commands.run('panel.solver');
        },
      },
    ];
    return commands.register(list);
  }, [commands, search, difficulty, proof]);
  return null;
}
