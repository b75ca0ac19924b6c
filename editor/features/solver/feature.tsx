import { Sparkles } from 'lucide-react';
import type { ComponentType } from 'react';
import { COLOURS, type DrawnPart, unchanged } from '../../canvas/index.ts';
import { Section } from '../../core/panel/index.ts';
import type { Feature } from '../feature.ts';
import { DifficultyReport } from './DifficultyReport.tsx';
import { FixReport } from './FixReport.tsx';
import { solverSessionOf } from './index.ts';
import { RobustnessReport } from './RobustnessReport.tsx';
import { HeatLegend, SearchLayer } from './SearchOverlay.tsx';
import { SearchReport, SearchSettingsForm } from './SearchSection.tsx';
import type { SearchOverlay } from './search-session.ts';
import { solverCommands, solverLevelCommands } from './solver-commands.ts';
import './solver.css';

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

/** The solver panel: search, fixes, robustness and difficulty. @param sections what other features examine */
function Solver({ sections }: { readonly sections: readonly ComponentType[] }) {
  return (
    <div className="panel__body solver">
      <Section title="Find runs">
        <SearchSettingsForm />
        <SearchReport />
      </Section>
      <FixReport />
      {sections.map((Part, key) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: the list never changes
        <Part key={key} />
      ))}
      <RobustnessReport />
      <DifficultyReport />
    </div>
  );
}
