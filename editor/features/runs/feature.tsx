import { Waypoints } from 'lucide-react';
import { flushSync } from 'react-dom';
import type { Destination } from '../../core/commands/index.ts';
import { type Editor, perLevel } from '../../core/context/index.ts';
import type { Feature } from '../feature.ts';
import { RunsPanel } from './RunsPanel.tsx';
import { SCRIPT_FIELD } from './ScriptField.tsx';

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
        document.getElementById(SCRIPT_FIELD)?.focus();
      },
    },
  ],
};
