import { Waypoints } from 'lucide-react';
import { flushSync } from 'react-dom';
import type { Destination } from '../../core/commands/index.ts';
import { type Editor, perLevel } from '../../core/context/index.ts';
import { laterPanel } from '../../core/panel/index.ts';
import type { Feature } from '../feature.ts';
import './runs.css';
import { SCRIPT_FIELD } from './index.ts';

const fetchPanel = () => import('./RunsPanel.tsx').then((there) => there.RunsPanel);
const RunsPanel = laterPanel(fetchPanel);

/** @returns whether the field is there */
function goToScript(): boolean {
  const field = document.getElementById(SCRIPT_FIELD);
  field?.focus();
  return field !== null;
}

/** The runs of the open level. */
function runDestinations({ open, session }: Editor): readonly Destination[] {
  return (open.getState()?.document.file().runs ?? []).map(({ name, holds }) => ({
    key: `run ${name}`,
    group: 'Run',
    title: name,
    detail: `${holds.length} ${holds.length === 1 ? 'hold' : 'holds'}`,
    go: () => session.setState({ run: name }),
  }));
}

/** The runs of the level: how they end, and the shown one as text. */
export const runs: Feature = {
  name: 'runs',
  panel: {
    id: 'runs',
    title: 'Runs',
    icon: <Waypoints size={17} />,
    side: 'left',
    place: 'tab',
    content: perLevel(RunsPanel),
  },
  destinations: runDestinations,
  commands: ({ open, commands }) => [
    {
      id: 'run.text',
      title: 'Edit the run as text',
      group: 'Run',
      keys: ['t'],
      needs: () => (open.getState()?.proof.proof().run.name == null ? 'show a run first' : null),
      run: () => {
        flushSync(() => commands.run('panel.runs'));
        if (goToScript()) return;
        // it comes with its panel, which says so if it can't be loaded
        fetchPanel().then(
          () => setTimeout(goToScript),
          () => undefined,
        );
      },
    },
  ],
};
