import type { Feature } from '../feature.ts';
import { AliveStatus } from './AliveStatus.tsx';
import { AliveToggle } from './AliveToggle.tsx';
import { ALIVE_KEY, keepAlive } from './keep-alive.ts';

/** Holds that are re-timed within the step that broke a run. */
export const alive: Feature = {
  name: 'alive',
  timeline: { buttons: AliveToggle },
  offer: AliveStatus,
  commands: ({ settings }) => [
    {
      id: 'run.keep-alive',
      title: 'Keep the run alive: turn it on or off',
      group: 'Run',
      keys: [ALIVE_KEY],
      run: () => settings.setState({ keepAlive: !settings.getState().keepAlive }),
    },
  ],
  open: ({ settings, desk }, level) => keepAlive({ level, settings, desk }),
};
