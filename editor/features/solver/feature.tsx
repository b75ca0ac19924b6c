import { Sparkles } from 'lucide-react';
import { COLOURS, type DrawnPart, unchanged } from '../../canvas/index.ts';
import type { Feature } from '../feature.ts';
import { solverSessionOf } from './index.ts';
import { HeatLegend, SearchLayer } from './SearchOverlay.tsx';
import type { SearchOverlay } from './search-session.ts';
import './solver.css';
import type { Command } from '../../core/commands/index.ts';
import type { Editor, OpenLevel } from '../../core/context/index.ts';
import { laterPanel } from '../../core/panel/index.ts';
import { SOLVE_KEY } from './search-task.ts';

const drawn: DrawnPart<SearchOverlay> = {
  pictureOf(editor, level) {
    const { overlay } = solverSessionOf(editor, level);
    return unchanged(
      () => [overlay.getState(), editor.session.getState().layers.heatMap] as const,
      ([{ heat, proof }, showsHeat]) => ({ heat: showsHeat ? heat : null, proof }),
    );
  },
  draw: (scene, theme) => new SearchLayer(scene, COLOURS[theme]),
};

/** Searches for runs and fixes, and what is measured and proved of the level. */
export const solver: Feature = {
  name: 'solver',
  layers: [{ id: 'heatMap', title: 'search heat map', isShown: false }],
  canvas: { drawn, legend: HeatLegend },
  panel: {
    id: 'solver',
    title: 'Solver',
    icon: <Sparkles size={17} />,
    side: 'right',
    place: 'tab',
    content: laterPanel(() => import('./SearchSection.tsx').then(({ Solver }) => Solver)),
  },
  commands: solverCommands,
  levelCommands: solverLevelCommands,
};

/** What can be done with the solver, whatever is shown. */
function solverCommands(editor: Editor): readonly Command[] {
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
function solverLevelCommands(editor: Editor, level: OpenLevel): readonly Command[] {
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
