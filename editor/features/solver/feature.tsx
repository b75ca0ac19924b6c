import { Sparkles } from 'lucide-react';
import { COLOURS, type DrawnPart, unchanged } from '../../canvas/index.ts';
import type { Feature } from '../feature.ts';
import type { SearchOverlay } from './overlay.ts';
import { HeatLegend } from './SearchOverlay.tsx';
import { Solver } from './Solver.tsx';
import { SearchLayer } from './search-layer.ts';
import { solverCommands, solverLevelCommands } from './solver-commands.ts';
import { solverSessionOf } from './solver-session.ts';

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
    content: Solver,
  },
  commands: solverCommands,
  levelCommands: solverLevelCommands,
};
