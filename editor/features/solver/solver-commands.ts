import type { Command } from '../../core/commands/index.ts';
import type { Editor, OpenLevel } from '../../core/context/index.ts';
import { solverSessionOf } from './index.ts';
import { SOLVE_KEY } from './search-task.ts';

/** What can be done with the solver, whatever is shown. */
export function solverCommands(editor: Editor): readonly Command[] {
  const { open, commands } = editor;
  return [
    {
      id: 'level.fix',
      title: 'Fix this level',
      group: 'Solve',
      needs: () => (open.getState() === null ? 'open a level first' : null),
      run() {
        const level = open.getState();
        if (level === null) return;
        commands.run('panel.solver');
        solverSessionOf(editor, level).fixes.start();
      },
    },
  ];
}

/** Searches and measurements of an open level. */
export function solverLevelCommands(editor: Editor, level: OpenLevel): readonly Command[] {
  const { commands } = editor;
  const { proof } = level;
  const { search, difficulty } = solverSessionOf(editor, level);
  const best = () => search.store.getState().found.find(({ works }) => works);
  const needsFound = () => (best() === undefined ? 'solve first: no run has been found yet' : null);
  return [
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
}
